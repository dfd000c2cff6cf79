#pragma once

#include "common/scene/scene_light.h"
#include "render/lights/light_kind.h"
#include "render/lights/parallel_light.h"

#include <vector>

namespace hipmap {

/// A light without size whose intensity by direction is a photometric web,
/// docs/light_transport.md (40).
struct IesLight {
    static constexpr LightRole kRole = LightRole::analytic;

    glm::vec3 position{0.0f};   ///< scene units
    glm::vec3 axis{0, 0, -1};   ///< unit, of the polar angle 0
    glm::vec3 start{0, -1, 0};  ///< unit, across the axis, of the azimuth 0
    glm::vec3 across{-1, 0, 0}; ///< unit, of the azimuth pi/2
    Rgb intensity{0.0f};        ///< W/sr / metres_per_unit^2 of one candela of the web
    PhotometricWeb web;
    float reach = 0.0f;        ///< polar angle beyond which there is no light
    std::vector<double> rings; ///< [P * A] the web's integral over azimuths, up to each
    std::vector<double> bands; ///< [P] the web's integral over directions, up to each polar angle
};

/// Makes the light, with its tables.  Cost: linear in the web.
IesLight light_from(const SceneIesLight& light, const SceneSphere& scene);

/// Returns the web in a direction (unit, away from the light), candela.
float candela_along(const IesLight& light, const glm::vec3& direction);

/// Draws a direction with a pdf in proportion to the web.
glm::vec3 sample_direction(const IesLight& light, RandomSequence& random);

/// Returns nothing at the light's own position.  Draws no random number.
std::optional<LightSample> sample_li(const IesLight& light, const LightReceiver& at,
                                     RandomSequence& random);

/// Returns nothing: no ray runs into a point.
inline std::optional<LightHit> intersect(const IesLight&, const Ray&)
{
    return std::nullopt;
}
inline bool can_be_met(const IesLight&)
{
    return false;
}

EmittedPath sample_emission(const IesLight& light, const PathPlace& path, RandomSequence& random);
EmittedPath sample_aimed_emission(const IesLight& light, const PathPlace& path,
                                  const std::vector<TargetSphere>& targets, RandomSequence& random);
glm::dvec3 power(const IesLight& light);
std::optional<LightBounds> bounds(const IesLight& light);

} // namespace hipmap
