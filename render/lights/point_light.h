#pragma once

#include "render/lights/light_kind.h"

namespace hipmap {

/// A light without size that emits the same intensity in all directions.
struct PointLight {
    static constexpr LightRole kRole = LightRole::analytic;

    glm::vec3 position{0.0f}; ///< scene units
    Rgb intensity{0.0f};      ///< W/sr / metres_per_unit^2
};

/// Returns nothing at the light's own position.  Draws no random number.
std::optional<LightSample> sample_li(const PointLight& light, const LightReceiver& at,
                                     RandomSequence& random);

/// Returns nothing: no ray runs into a point.
inline std::optional<LightHit> intersect(const PointLight&, const Ray&)
{
    return std::nullopt;
}
inline bool can_be_met(const PointLight&)
{
    return false;
}

EmittedPath sample_emission(const PointLight& light, const PathPlace& path, RandomSequence& random);
EmittedPath sample_aimed_emission(const PointLight& light, const PathPlace& path,
                                  const std::vector<TargetSphere>& targets, RandomSequence& random);
glm::dvec3 power(const PointLight& light);
std::optional<LightBounds> bounds(const PointLight& light);

} // namespace hipmap
