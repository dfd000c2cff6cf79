#pragma once

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>

namespace hipmap {

/// Returns 1 - cos of half the angle that a sphere takes as seen from a light: the solid angle of
/// the cone around it over 2 pi.  2 from inside, 0 if the light misses it.  way: from the light to
/// the centre.  axis: unit; the light goes out up to half_angle, in radians, off it.
inline float cone_height(const glm::vec3& way, float radius, const glm::vec3& axis,
                         float half_angle)
{
    constexpr float kAngleMargin = 1e-3f; // for rounding
    const float distance2 = glm::dot(way, way), radius2 = radius * radius;
    if (distance2 <= radius2)
        return 2;
    const float sin2 = radius2 / distance2;
    const float off_axis =
        std::acos(std::clamp(glm::dot(way, axis) / std::sqrt(distance2), -1.0f, 1.0f));
    if (off_axis > half_angle + std::asin(std::sqrt(sin2)) + kAngleMargin)
        return 0;
    return sin2 / (1 + std::sqrt(1 - sin2)); // without cancellation
}

} // namespace hipmap
