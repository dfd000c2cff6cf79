#pragma once

#include "render/lights/light_kind.h"

#include <cmath>

namespace hipmap {

/// Samples a light without size at a position.  intensity(direction): W/sr / metres_per_unit^2
/// along a unit direction away from the light.  Returns nothing at the light's own position.
template <typename Intensity>
std::optional<LightSample> sample_point(const glm::vec3& position, const LightReceiver& at,
                                        const Intensity& intensity)
{
    const glm::vec3 way = position - at.position;
    const float distance2 = glm::dot(way, way);
    if (!(distance2 > 0))
        return std::nullopt;
    LightSample out;
    out.direction = way / std::sqrt(distance2);
    out.point = position;
    out.light = intensity(-out.direction) / distance2;
    return out;
}

} // namespace hipmap
