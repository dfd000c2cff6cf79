#pragma once

#include "render/lights/parallel_light.h"

namespace hipmap {

/// An environment of the same radiance from all directions.
struct ConstantEnvironment {
    static constexpr LightRole kRole = LightRole::environment;

    Rgb radiance{0.0f}; ///< W/(m2 sr)
    SceneSphere scene;
};

/// Returns nothing: rays drawn by the lobes of a surface find it with less noise.
inline std::optional<LightSample> sample_li(const ConstantEnvironment&, const LightReceiver&,
                                            RandomSequence&)
{
    return std::nullopt;
}

/// Returns the environment, which every ray meets, with pdf 0.
std::optional<LightHit> intersect(const ConstantEnvironment& light, const Ray& ray);
inline bool can_be_met(const ConstantEnvironment&)
{
    return true;
}

EmittedPath sample_emission(const ConstantEnvironment& light, const PathPlace& path,
                            RandomSequence& random);
/// Returns what `sample_emission` draws for light along a ray of the scene, in its first two steps.
PrimarySample primary_of(const ConstantEnvironment& light, const Ray& ray,
                         const PrimarySample& unused);
EmittedPath sample_aimed_emission(const ConstantEnvironment& light, const PathPlace& path,
                                  const std::vector<TargetSphere>& targets, RandomSequence& random);

/// Returns the power of all light through the discs of the scene's sphere, docs/light_transport.md
/// (7).
glm::dvec3 power(const ConstantEnvironment& light);

/// Returns nothing: the environment lies outside the scene.
inline std::optional<LightBounds> bounds(const ConstantEnvironment&)
{
    return std::nullopt;
}

} // namespace hipmap
