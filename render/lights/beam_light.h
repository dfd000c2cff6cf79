#pragma once

#include "common/scene/scene_light.h"
#include "render/lights/flat_shape.h"
#include "render/lights/light_kind.h"
#include "render/lights/parallel_light.h"

namespace hipmap {

/// A rectangle or an ellipse that emits parallel light across itself, docs/light_transport.md (48).
struct BeamLight {
    static constexpr LightRole kRole = LightRole::analytic;

    FlatShape shape;
    glm::vec3 direction{0, 0, -1}; ///< unit, across the shape
    Rgb irradiance{0.0f};          ///< W/m2 across the direction
};

BeamLight light_from(const SceneBeamLight& light, const SceneSphere& scene);

/// Returns nothing outside the beam and behind its light.  Draws no random number.
std::optional<LightSample> sample_li(const BeamLight& light, const LightReceiver& at,
                                     RandomSequence& random);

/// Returns nothing: only rays along the beam could meet it.
inline std::optional<LightHit> intersect(const BeamLight&, const Ray&)
{
    return std::nullopt;
}
inline bool can_be_met(const BeamLight&)
{
    return false;
}

EmittedPath sample_emission(const BeamLight& light, const PathPlace& path, RandomSequence& random);
/// Aims only where the beam is wider than the targets together; paths elsewhere have no power.
EmittedPath sample_aimed_emission(const BeamLight& light, const PathPlace& path,
                                  const std::vector<TargetSphere>& targets, RandomSequence& random);
glm::dvec3 power(const BeamLight& light);
std::optional<LightBounds> bounds(const BeamLight& light);

} // namespace hipmap
