#pragma once

#include "render/shading/render_scene.h"

#include <cstdint>
#include <vector>

namespace hipmap {

/// How the light paths of a pass are shared out: by power, each light with a floor share.
/// The lights are the lamps (lamps.h), then all emissive faces as one, then the sky, then media
/// that glow.
struct EmissionPlan {
    std::vector<std::uint64_t>
        first_path; ///< [lights + 1] light i owns paths [first[i], first[i+1])
    std::uint64_t paths = 0;
};

/// Every light that shines gets at least one path; none if nothing shines or `paths` is 0.
/// glow: power of media that glow, largest channel.
EmissionPlan plan_emission(const LightSet& lights, std::uint64_t paths, double glow = 0);

/// Which light a path belongs to.
struct LightShare {
    std::size_t light = 0;
    std::uint64_t place = 0; ///< of the path among those of its light
    std::uint64_t paths = 0; ///< of the light
};

/// path: 0..plan.paths-1.
LightShare share_of(const EmissionPlan& plan, std::uint64_t path);

/// Uniform in [0, 1), stratified over the paths of a light.
double stratum(const LightShare& share, RandomSequence& random);

/// Parallel light from the sky.
struct SkyLight {
    glm::vec3 direction{0.0f}; ///< unit, along which it travels
    Rgb light{0.0f};           ///< W/m2 across that, divided by its density per solid angle
};

/// Evenly from a uniform sky, by the largest channel from a picture.
SkyLight sample_sky_light(const LightSet& lights, const glm::vec2& u);

/// The start of a light path.
struct EmittedPath {
    Ray ray;
    Rgb power{0.0f}; ///< already divided by the paths of its light
    bool from_medium = false;
};

/// path: 0..plan.paths-1.  Source: docs/light_transport.md (5)-(7), (26).
EmittedPath emit_path(const RenderScene& scene, const EmissionPlan& plan, std::uint64_t path,
                      RandomSequence& random);

} // namespace hipmap
