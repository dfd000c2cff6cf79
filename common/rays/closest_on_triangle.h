#pragma once

#include <glm/vec3.hpp>

namespace hipmap {

/// Returns the point of a triangle nearest to a given point.  A triangle without area counts as its
/// longest edge, or as a point.
glm::vec3 closest_on_triangle(const glm::vec3& point, const glm::vec3& a, const glm::vec3& b,
                              const glm::vec3& c);

} // namespace hipmap
