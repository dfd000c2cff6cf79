#pragma once

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>

namespace hipmap {

/// Returns z of the cross product: above zero if v is counter-clockwise of u.
inline double cross(const glm::dvec2& u, const glm::dvec2& v)
{
    return u.x * v.y - u.y * v.x;
}

/// Returns a key from 0 to 4 that grows with the direction of p from +x counter-clockwise; opposite
/// directions are 2 apart.
inline double direction_key(const glm::dvec2& p)
{
    const double t = p.y / (std::abs(p.x) + std::abs(p.y));
    if (p.x < 0)
        return 2 - t;
    return p.y < 0 ? 4 + t : t;
}

/// Returns the squared distance from the origin to the segment.
inline double distance2(const glm::dvec2& a, const glm::dvec2& b)
{
    const glm::dvec2 along = b - a;
    const double t = std::clamp(-glm::dot(a, along) / glm::dot(along, along), 0.0, 1.0);
    const glm::dvec2 nearest = a + t * along;
    return glm::dot(nearest, nearest);
}

} // namespace hipmap
