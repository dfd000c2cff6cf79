#pragma once

#include "render/lights/light_set.h"
#include "render/lights/primary_density.h"

#include <cstdint>
#include <vector>

namespace hipmap {

/// Assigns the light paths of a pass to lights: by power, with a minimum share for each light.
struct EmissionPlan {
    /// [lights + 1] LightSet::lights[i] owns paths [first_path[i], first_path[i + 1])
    std::vector<std::uint64_t> first_path;
    std::uint64_t paths = 0;
};

/// The lights that a plan has paths for.
enum class Emitters : std::uint8_t { all, all_but_media };

/// How the light paths of a pass are spread over the lights and, of each light, over their starts,
/// docs/light_transport.md (41).
struct EmissionGuide {
    struct OfLight {
        double share = 0; ///< of all paths
        PrimaryDensity density;
    };
    std::vector<OfLight> lights; ///< [lights]
    double variance = 1;         ///< of what its paths are worth, over that of paths by power
};

/// Returns the guide without knowledge: lights share by power, with a minimum share for each.
EmissionGuide even_guide(const LightSet& lights, Emitters emitters);

/// Plans the light paths of a pass.  Every light that emits gets at least one path; there are none
/// if nothing emits or `paths` is 0.
EmissionPlan plan_emission(const EmissionGuide& guide, std::uint64_t paths);

/// Plans them by the even guide.
EmissionPlan plan_emission(const LightSet& lights, std::uint64_t paths, Emitters emitters);

/// The light that a path belongs to, and its place among the light's paths.
struct LightShare {
    std::size_t light = 0; ///< place in LightSet::lights
    PathPlace path;
};

/// Returns the light of a path.  path: 0..plan.paths-1.
LightShare share_of(const EmissionPlan& plan, std::uint64_t path);

/// Returns the start of a light path, its power divided by the number of paths of its light.
/// Source: docs/light_transport.md (5)-(7), (26).
EmittedPath emit_path(const LightSet& lights, const LightShare& share, RandomSequence& random);

/// Returns the start of a light path aimed at the targets; for light that reaches them, its
/// expectation equals that of `emit_path`.  There must be a target.
EmittedPath emit_aimed_path(const LightSet& lights, const LightShare& share,
                            const std::vector<TargetSphere>& targets, RandomSequence& random);

/// Draws the first steps of a path of a light by a guide.
inline DrawnPrimary draw_start(const EmissionGuide& guide, std::size_t light,
                               RandomSequence& random)
{
    PrimarySample even;
    for (glm::vec2& step : even)
        step = random.next2();
    return draw(guide.lights[light].density, even);
}

/// Returns the start that `emit(share, random)` makes of a light path from first steps that a guide
/// drew; of the same expectation.
template <typename Emit>
EmittedPath emit_from(const DrawnPrimary& start, const LightShare& share, RandomSequence& random,
                      const Emit& emit)
{
    random.give(start.at);
    EmittedPath out = emit(LightShare{share.light, {}}, random);
    random.take_back();
    out.power /= start.density * static_cast<float>(share.path.paths);
    return out;
}

} // namespace hipmap
