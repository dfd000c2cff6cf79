#pragma once

#include "render/lights/light_kind.h"
#include "render/lights/spot_cone.h"

namespace hipmap {

/// A light without size that emits into a cone.
struct SpotLight {
    static constexpr LightRole kRole = LightRole::analytic;

    glm::vec3 position{0.0f}; ///< scene units
    Rgb intensity{0.0f};      ///< W/sr / metres_per_unit^2, along the axis
    SpotCone cone;
};

/// Returns nothing at the light's own position.  Draws no random number.
std::optional<LightSample> sample_li(const SpotLight& light, const LightReceiver& at,
                                     RandomSequence& random);

/// Returns nothing: no ray runs into a point.
inline std::optional<LightHit> intersect(const SpotLight&, const Ray&)
{
    return std::nullopt;
}
inline bool can_be_met(const SpotLight&)
{
    return false;
}

EmittedPath sample_emission(const SpotLight& light, const PathPlace& path, RandomSequence& random);
EmittedPath sample_aimed_emission(const SpotLight& light, const PathPlace& path,
                                  const std::vector<TargetSphere>& targets, RandomSequence& random);
glm::dvec3 power(const SpotLight& light);
std::optional<LightBounds> bounds(const SpotLight& light);

} // namespace hipmap
