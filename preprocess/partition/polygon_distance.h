#pragma once

#include <glm/glm.hpp>

#include <array>
#include <span>

namespace hipmap {

/// A flat convex polygon: a triangle clipped by at most three planes.
class ConvexPolygon {
  public:
    /// Makes the polygon.  normal: of the corners' plane, any length, corners counter-clockwise
    /// around it.
    ConvexPolygon(const std::array<glm::dvec3, 3>& corners, const glm::dvec3& normal)
        : normal_(normal), count_(3)
    {
        for (std::size_t i = 0; i < 3; ++i)
            points_[i] = corners[i];
    }

    std::span<const glm::dvec3> points() const { return std::span(points_).first(count_); }
    const glm::dvec3& normal() const { return normal_; }

    /// Keeps the part in front of a plane, dot(point - origin, inward) > level; nothing where the
    /// polygon only touches it.  At most three calls.
    void clip(const glm::dvec3& origin, const glm::dvec3& inward, double level);

  private:
    glm::dvec3 normal_;
    /// The most corners: three clips give six, and nine where rounding makes the outline waver.
    static constexpr std::size_t kMostPoints = 9;

    std::array<glm::dvec3, kMostPoints> points_;
    std::size_t count_;
};

/// Returns the distance between two polygons of at least three points; 0 where they meet.
double distance(const ConvexPolygon& a, const ConvexPolygon& b);

} // namespace hipmap
