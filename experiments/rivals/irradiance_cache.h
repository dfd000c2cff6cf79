#pragma once

#include "common/math/random.h"
#include "experiments/rivals/rival.h"

#include <array>
#include <functional>

namespace hipmap {

/// The irradiance at a point and how it changes about the point: Ward et al. 1988, Ward and
/// Heckbert 1992.
struct CacheRecord {
    glm::vec3 position{0.0f};
    glm::vec3 normal{0.0f};
    Rgb irradiance{0.0f};
    float distance = 0.0f;             ///< harmonic mean to what is seen from the point
    std::array<glm::vec3, 3> turned{}; ///< gradient of each channel by rotation of the normal
    std::array<glm::vec3, 3> moved{};  ///< and by translation, 1/scene unit
};

/// Samples the light of a hemisphere by about so many rays, stratified.
/// incoming(ray, random, distance) returns the radiance along a ray and sets the distance that it
/// goes; infinite: it leaves the scene.
using IncomingLight = std::function<Rgb(const Ray&, RandomSequence&, float& distance)>;
CacheRecord sample_hemisphere(const SurfacePoint& point, const glm::vec3& normal, int rays,
                              const IncomingLight& incoming, RandomSequence& random);

/// Renders with irradiance caching: indirect light of diffuse surfaces is sampled by a hemisphere
/// of paths at each of few points, and interpolated between these.  Direct light is found
/// by shadow rays; caustics are left out, as in Ward's method.  The scene has no media.
RivalImage render_irradiance_cache(const RenderScene& scene, const RivalSettings& settings);

} // namespace hipmap
