#pragma once

#include "render/lights/parallel_light.h"

namespace hipmap {

/// A sun: parallel light, or light from a disc in the sky, docs/light_transport.md (26).
struct SunLight {
    static constexpr LightRole kRole = LightRole::analytic;

    glm::vec3 direction{0, 0, -1}; ///< unit, along which its light travels
    Rgb irradiance{0.0f};          ///< W/m2 on a plane across the direction
    float half_angle = 0.0f;       ///< half the angle that it fills, radians; 0: no size
    SceneSphere scene;
};

/// Draws a direction evenly from the sun's disc.  A sun without a size draws no random number.
std::optional<LightSample> sample_li(const SunLight& light, const LightReceiver& at,
                                     RandomSequence& random);

/// Returns the sun if a ray meets its disc; nothing for a sun without a size.
std::optional<LightHit> intersect(const SunLight& light, const Ray& ray);
inline bool can_be_met(const SunLight& light)
{
    return light.half_angle > 0;
}

FarLight far_light(const SunLight& light);

EmittedPath sample_emission(const SunLight& light, const PathPlace& path, RandomSequence& random);
PrimarySample primary_of(const SunLight& light, const Ray& ray, const PrimarySample& unused);
EmittedPath sample_aimed_emission(const SunLight& light, const PathPlace& path,
                                  const std::vector<TargetSphere>& targets, RandomSequence& random);

/// Returns the power of all light through the discs of the scene's sphere.
glm::dvec3 power(const SunLight& light);

/// Returns nothing: the sun lies outside the scene.
inline std::optional<LightBounds> bounds(const SunLight&)
{
    return std::nullopt;
}

} // namespace hipmap
