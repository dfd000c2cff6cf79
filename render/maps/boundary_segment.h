#pragma once

#include <glm/glm.hpp>

namespace hipmap {

/// A piece of the boundary of a map, scene units.
struct BoundarySegment {
    glm::vec3 a, b;
    bool operator==(const BoundarySegment&) const = default;
};

/// Returns the square distance to the nearest point of a segment, square scene units.
double distance2_to_segment(const glm::vec3& point, const BoundarySegment& segment);

} // namespace hipmap
