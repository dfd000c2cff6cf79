#pragma once

#include <glm/glm.hpp>

#include <array>
#include <span>

namespace hipmap {

/// A triangle as a point sees it.  Lengths in scene units.
class TriangleAround {
  public:
    TriangleAround(const std::array<glm::vec3, 3>& corners, const glm::dvec3& point);

    /// Returns half the cross product of two edges.
    const glm::dvec3& vector() const { return vector_; }
    /// Returns the middle, from the point.
    glm::dvec3 middle() const { return (to_[0] + to_[1] + to_[2]) / 3.0; }
    /// Returns a square distance that nothing of the triangle is nearer than.
    double nearest2() const;
    /// Returns the square distance of the farthest corner.
    double farthest2() const;
    /// Returns the longest side of the box around it.
    double extent() const;
    /// Adds to each area, square scene units, what lies within its radius (>= 0, finite) of the
    /// point, times a weight.
    void add_within(std::span<const float> radii, double weight, std::span<double> areas) const;

  private:
    std::array<glm::dvec3, 3> to_; ///< the corners, from the point
    glm::dvec3 low_, high_, vector_;
};

} // namespace hipmap
