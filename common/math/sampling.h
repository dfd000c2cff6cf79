#pragma once

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hipmap {

inline constexpr float kPi = std::numbers::pi_v<float>;

/// Returns a point of the unit disc, uniform by area (polar map).  u: [0, 1)^2.
inline glm::vec2 sample_disc(const glm::vec2& u)
{
    const float r = std::sqrt(u.x);
    const float phi = 2 * kPi * u.y;
    return {r * std::cos(phi), r * std::sin(phi)};
}

/// Returns the u from which `sample_disc` makes a point of the unit disc.
inline glm::vec2 disc_sample_of(const glm::vec2& point)
{
    const float turn = std::atan2(point.y, point.x) / (2 * kPi);
    return {glm::dot(point, point), turn < 0 ? turn + 1 : turn};
}

/// Returns a unit vector of the upper hemisphere about +z with pdf cos(theta) / pi.  u: [0, 1)^2.
inline glm::vec3 sample_cosine_hemisphere(const glm::vec2& u)
{
    const glm::vec2 d = sample_disc(u);
    return {d.x, d.y, std::sqrt(std::max(0.0f, 1 - d.x * d.x - d.y * d.y))};
}

/// Returns a unit vector about +z with the given cosine and a uniform azimuth.  u: [0, 1).
inline glm::vec3 direction_from_cosine(float cos_theta, float u)
{
    const float sin_theta = std::sqrt(std::max(0.0f, 1 - cos_theta * cos_theta));
    const float phi = 2 * kPi * u;
    return {sin_theta * std::cos(phi), sin_theta * std::sin(phi), cos_theta};
}

/// Returns a uniform unit vector, with pdf 1 / (4 pi).  u: [0, 1)^2.
inline glm::vec3 sample_sphere(const glm::vec2& u)
{
    return direction_from_cosine(1 - 2 * u.x, u.y);
}

/// Returns the u from which `sample_sphere` makes a unit vector.
inline glm::vec2 sphere_sample_of(const glm::vec3& direction)
{
    const float turn = std::atan2(direction.y, direction.x) / (2 * kPi);
    return {(1 - direction.z) / 2, turn < 0 ? turn + 1 : turn};
}

/// Returns barycentric coordinates (of the second and third corner), uniform by area.  u: [0, 1)^2.
inline glm::vec2 sample_triangle(const glm::vec2& u)
{
    const float s = std::sqrt(u.x);
    return {s * (1 - u.y), s * u.y};
}

} // namespace hipmap
