#pragma once

#include "render/lights/light_kind.h"
#include "render/lights/spot_cone.h"

namespace hipmap {

/// A point or spot light with a radius: a sphere of constant intensity over its visible disc,
/// docs/light_transport.md (26).
struct SphereLight {
    static constexpr LightRole kRole = LightRole::analytic;

    glm::vec3 position{0.0f};     ///< of its centre, scene units
    float radius = 0.0f;          ///< scene units, above zero
    Rgb intensity{0.0f};          ///< W/sr / metres_per_unit^2, of a spot along its axis
    std::optional<SpotCone> cone; ///< of a spot
};

/// Draws a direction evenly from the cone that the sphere fills.  Returns nothing inside the
/// sphere.
std::optional<LightSample> sample_li(const SphereLight& light, const LightReceiver& at,
                                     RandomSequence& random);

/// Returns the near side of the sphere; nothing from inside.
std::optional<LightHit> intersect(const SphereLight& light, const Ray& ray);
inline bool can_be_met(const SphereLight&)
{
    return true;
}

EmittedPath sample_emission(const SphereLight& light, const PathPlace& path,
                            RandomSequence& random);
EmittedPath sample_aimed_emission(const SphereLight& light, const PathPlace& path,
                                  const std::vector<TargetSphere>& targets, RandomSequence& random);
glm::dvec3 power(const SphereLight& light);
std::optional<LightBounds> bounds(const SphereLight& light);

} // namespace hipmap
