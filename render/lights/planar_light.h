#pragma once

#include "render/lights/flat_shape.h"
#include "render/lights/light_kind.h"
#include "render/lights/spread.h"

namespace hipmap {

/// An area light, which emits to one side, docs/light_transport.md (26).
struct PlanarLight {
    static constexpr LightRole kRole = LightRole::analytic;

    FlatShape shape;
    glm::vec3 direction{0, 0, -1}; ///< unit, the side that emits
    Rgb radiance{0.0f};            ///< W/(m2 sr), of an even light of the same power
    Spread spread;
};

/// Draws a point evenly from the area.  Returns nothing from behind, in the light's plane, or
/// beyond its spread.
std::optional<LightSample> sample_li(const PlanarLight& light, const LightReceiver& at,
                                     RandomSequence& random);

/// Returns where a ray meets the light; nothing from behind or beyond its spread.
std::optional<LightHit> intersect(const PlanarLight& light, const Ray& ray);
inline bool can_be_met(const PlanarLight&)
{
    return true;
}

EmittedPath sample_emission(const PlanarLight& light, const PathPlace& path,
                            RandomSequence& random);
EmittedPath sample_aimed_emission(const PlanarLight& light, const PathPlace& path,
                                  const std::vector<TargetSphere>& targets, RandomSequence& random);
glm::dvec3 power(const PlanarLight& light);
std::optional<LightBounds> bounds(const PlanarLight& light);

} // namespace hipmap
