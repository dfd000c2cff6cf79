#pragma once

#include <glm/vec3.hpp>

namespace hipmap {

/// The point of a triangle nearest to a point: of its plane, if that lies inside, else of an edge.
/// A triangle without area is its longest edge, or a point.
glm::vec3 closest_on_triangle(const glm::vec3& point, const glm::vec3& a, const glm::vec3& b,
                              const glm::vec3& c);

} // namespace hipmap
