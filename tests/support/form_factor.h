#pragma once

#include <glm/glm.hpp>

#include <cmath>
#include <vector>

namespace hipmap {

/// Irradiance under a parallel rectangle of radiance 1 at height h whose corner lies straight above
/// the point; sides a, b.  Source: the configuration factor of Howell's catalogue, C-11, times pi.
inline double corner_rectangle(double a, double b, double h)
{
    const double p = a / h, q = b / h;
    const double u = std::sqrt(1 + p * p), v = std::sqrt(1 + q * q);
    return 0.5 * (p / u * std::atan(q / u) + q / v * std::atan(p / v));
}

/// Irradiance at `point` by a polygon of radiance 1, all of it in front of the surface and all
/// seen. corners: in order, either way round.  normal: of the surface there, unit. Source: Lambert,
/// Photometria (1760).
inline double polygon_irradiance(const glm::dvec3& point, const glm::dvec3& normal,
                                 const std::vector<glm::dvec3>& corners)
{
    double sum = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const glm::dvec3 a = glm::normalize(corners[i] - point);
        const glm::dvec3 b = glm::normalize(corners[(i + 1) % corners.size()] - point);
        const double angle = std::acos(glm::dot(a, b));
        sum += 0.5 * angle * glm::dot(normal, glm::normalize(glm::cross(a, b)));
    }
    return std::abs(sum);
}

/// The part of what one of two equal parallel squares, straight opposite each other, sends out
/// that reaches the other; x: their side over their distance.  Source: Howell's catalogue, C-11.
inline double facing_squares(double x)
{
    const double u = std::sqrt(1 + x * x);
    return 2 / (M_PI * x * x) *
           (std::log(u * u / std::sqrt(1 + 2 * x * x)) + 2 * x * u * std::atan(x / u) -
            2 * x * std::atan(x));
}

/// Mean of f(u, v) over the square of the side about the origin, by midpoints.
template <typename Function>
double mean_over_square(double side, const Function& f)
{
    constexpr int kCells = 64;
    double sum = 0;
    for (int i = 0; i < kCells; ++i)
        for (int j = 0; j < kCells; ++j)
            sum += f(side * ((i + 0.5) / kCells - 0.5), side * ((j + 0.5) / kCells - 0.5));
    return sum / (kCells * kCells);
}

} // namespace hipmap
