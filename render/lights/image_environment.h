#pragma once

#include "render/lights/environment_map.h"
#include "render/lights/parallel_light.h"

namespace hipmap {

/// An environment with the radiance of an environment map.
struct ImageEnvironment {
    static constexpr LightRole kRole = LightRole::environment;

    const EnvironmentMap* map = nullptr; ///< not empty; borrowed
    SceneSphere scene;
};

/// Draws a direction by the largest channel of the map.
std::optional<LightSample> sample_li(const ImageEnvironment& light, const LightReceiver& at,
                                     RandomSequence& random);

/// Returns the environment, which every ray meets.
std::optional<LightHit> intersect(const ImageEnvironment& light, const Ray& ray);
inline bool can_be_met(const ImageEnvironment&)
{
    return true;
}

EmittedPath sample_emission(const ImageEnvironment& light, const PathPlace& path,
                            RandomSequence& random);
/// Returns what `sample_emission` draws for light along a ray of the scene, in its first two steps.
PrimarySample primary_of(const ImageEnvironment& light, const Ray& ray,
                         const PrimarySample& unused);
EmittedPath sample_aimed_emission(const ImageEnvironment& light, const PathPlace& path,
                                  const std::vector<TargetSphere>& targets, RandomSequence& random);

/// Returns the power of all light through the discs of the scene's sphere, docs/light_transport.md
/// (27).
glm::dvec3 power(const ImageEnvironment& light);
double path_power(const ImageEnvironment& light);

/// Returns nothing: the environment lies outside the scene.
inline std::optional<LightBounds> bounds(const ImageEnvironment&)
{
    return std::nullopt;
}

} // namespace hipmap
