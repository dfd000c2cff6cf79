#pragma once

#include "render/lights/light_set.h"

#include <cstdint>
#include <vector>

namespace hipmap {

/// How the light paths of a pass are shared out: by power, each light with a floor share.
struct EmissionPlan {
    /// [lights + 1] LightSet::lights[i] owns paths [first_path[i], first_path[i + 1])
    std::vector<std::uint64_t> first_path;
    std::uint64_t paths = 0;
};

/// Which lights a plan has paths for.
enum class Emitters : std::uint8_t { all, all_but_media };

/// Every light that emits gets at least one path; none if nothing emits or `paths` is 0.
EmissionPlan plan_emission(const LightSet& lights, std::uint64_t paths, Emitters emitters);

/// Which light a path belongs to.
struct LightShare {
    std::size_t light = 0; ///< place in LightSet::lights
    PathPlace path;
};

/// path: 0..plan.paths-1.
LightShare share_of(const EmissionPlan& plan, std::uint64_t path);

/// The start of a light path, its power divided by the paths of its light.
/// Source: docs/light_transport.md (5)-(7), (26).
EmittedPath emit_path(const LightSet& lights, const LightShare& share, RandomSequence& random);

/// The start of a light path that is aimed at the targets, with the same light in expectation as
/// `emit_path` for what passes through them.  There must be a target.
EmittedPath emit_aimed_path(const LightSet& lights, const LightShare& share,
                            const std::vector<TargetSphere>& targets, RandomSequence& random);

} // namespace hipmap
