#pragma once

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hipmap {

inline constexpr float kPi = std::numbers::pi_v<float>;

/// Point of the unit disc, area-uniform (polar map).  u: [0, 1)^2.
inline glm::vec2 sample_disc(const glm::vec2& u)
{
    const float r = std::sqrt(u.x);
    const float phi = 2 * kPi * u.y;
    return {r * std::cos(phi), r * std::sin(phi)};
}

/// Unit vector of the upper hemisphere about +z, density cos(theta) / pi.
inline glm::vec3 sample_cosine_hemisphere(const glm::vec2& u)
{
    const glm::vec2 d = sample_disc(u);
    return {d.x, d.y, std::sqrt(std::max(0.0f, 1 - d.x * d.x - d.y * d.y))};
}

/// Unit vector about +z with the given cosine and a uniform azimuth.
inline glm::vec3 direction_from_cosine(float cos_theta, float u)
{
    const float sin_theta = std::sqrt(std::max(0.0f, 1 - cos_theta * cos_theta));
    const float phi = 2 * kPi * u;
    return {sin_theta * std::cos(phi), sin_theta * std::sin(phi), cos_theta};
}

/// Uniform unit vector, density 1 / (4 pi).
inline glm::vec3 sample_sphere(const glm::vec2& u)
{
    return direction_from_cosine(1 - 2 * u.x, u.y);
}

/// Barycentric coordinates (of the second and third corner), area-uniform.
inline glm::vec2 sample_triangle(const glm::vec2& u)
{
    const float s = std::sqrt(u.x);
    return {s * (1 - u.y), s * u.y};
}

} // namespace hipmap
