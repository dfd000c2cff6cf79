#pragma once

#include "common/math/bounds.h"

#include <glm/glm.hpp>

#include <cstdint>

namespace hipmap {

/// A rectangle or an ellipse.
struct FlatShape {
    enum class Outline : std::uint8_t { rectangle, ellipse };

    Outline outline = Outline::rectangle;
    glm::vec3 centre{0.0f};        ///< scene units
    glm::vec3 half_right{1, 0, 0}; ///< from the centre to the middle of a side, scene units
    glm::vec3 half_up{0, 1, 0};    ///< need not be at right angles to half_right
};

/// Returns the area in square scene units.
double area(const FlatShape& shape);

/// Returns a point of it; evenly drawn u give points evenly drawn by area.
glm::vec3 point_on(const FlatShape& shape, const glm::vec2& u);

/// Returns whether a point of its plane is in it.  A shape without area has no points.
bool holds(const FlatShape& shape, const glm::vec3& point);

/// Returns a box around it.
Bounds<glm::vec3> bounds(const FlatShape& shape);

} // namespace hipmap
