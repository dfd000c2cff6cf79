#include "render/maps/triangle_around.h"

#include "render/maps/plane_directions.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hipmap {

namespace {

/// The angle that a triangle takes up about the origin: of a circle around which it lies.
double angle_around(const std::array<glm::dvec2, 3>& corners)
{
    bool around = true;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec2 &a = corners[(i + 1) % 3], &b = corners[(i + 2) % 3];
        if (corners[i] == glm::dvec2(0))
            return std::atan2(cross(a, b), glm::dot(a, b));
        around = around && cross(a, b) >= 0;
    }
    return around ? 2 * std::numbers::pi : 0;
}

/// What a straight edge from a to b changes of twice the area of a polygon about the origin within
/// a circle: the triangle under the part of it that lies in the circle, less the sector there.
double area2_of_chord(const glm::dvec2& a, const glm::dvec2& b, double radius2)
{
    const glm::dvec2 along = b - a;
    const double length2 = glm::dot(along, along);
    const double middle = -glm::dot(a, along) / length2; // parameter of the point nearest to 0
    const glm::dvec2 nearest = a + middle * along;
    const double half2 = (radius2 - glm::dot(nearest, nearest)) / length2;
    if (!(half2 > 0))
        return 0;
    const double half = std::sqrt(half2);
    const double from = std::max(0.0, middle - half), to = std::min(1.0, middle + half);
    if (!(from < to))
        return 0;
    const glm::dvec2 enter = a + from * along, leave = a + to * along;
    const double twice = cross(enter, leave);
    return twice - radius2 * std::atan2(twice, glm::dot(enter, leave));
}

} // namespace

TriangleAround::TriangleAround(const std::array<glm::vec3, 3>& corners, const glm::dvec3& point)
    : to_{glm::dvec3(corners[0]) - point, glm::dvec3(corners[1]) - point,
          glm::dvec3(corners[2]) - point},
      low_(glm::min(glm::min(to_[0], to_[1]), to_[2])),
      high_(glm::max(glm::max(to_[0], to_[1]), to_[2])),
      vector_(0.5 * glm::cross(to_[1] - to_[0], to_[2] - to_[0]))
{
}

double TriangleAround::nearest2() const
{
    const glm::dvec3 outside = glm::max(glm::max(low_, -high_), glm::dvec3(0));
    return glm::dot(outside, outside);
}

double TriangleAround::farthest2() const
{
    return std::max({glm::dot(to_[0], to_[0]), glm::dot(to_[1], to_[1]), glm::dot(to_[2], to_[2])});
}

double TriangleAround::extent() const
{
    const glm::dvec3 extent = high_ - low_;
    return std::max({extent.x, extent.y, extent.z});
}

void TriangleAround::add_within(std::span<const float> radii, double weight,
                                std::span<double> areas) const
{
    const double area = glm::length(vector_), near2 = nearest2(), far2 = farthest2();
    if (!(area > 0))
        return;
    const glm::dvec3 normal = vector_ / area;
    const double height = glm::dot(to_[0], normal);
    const glm::dvec3 x = glm::normalize(to_[1] - to_[0]), y = glm::cross(normal, x);
    std::array<glm::dvec2, 3> flat;
    for (std::size_t i = 0; i < 3; ++i)
        flat[i] = {glm::dot(to_[i], x), glm::dot(to_[i], y)};
    const double angle = angle_around(flat);
    for (std::size_t r = 0; r < radii.size(); ++r) {
        const double radius2 = double{radii[r]} * radii[r];
        const double in_plane2 = radius2 - height * height;
        if (far2 <= radius2)
            areas[r] += weight * area;
        else if (near2 < radius2 && in_plane2 > 0) {
            double area2 = angle * in_plane2;
            for (std::size_t i = 0; i < 3; ++i)
                area2 += area2_of_chord(flat[i], flat[(i + 1) % 3], in_plane2);
            areas[r] += weight * std::clamp(area2 / 2, 0.0, area);
        }
    }
}

} // namespace hipmap
