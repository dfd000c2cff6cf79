#pragma once

#include "common/math/sampling.h"

#include <array>
#include <cstddef>

namespace hipmap {

/// A density over directions by which final-gather rays look for light, mixed with that of the
/// lobes, or by which the sky is sampled.  It is even within the cells of a grid of equal solid
/// angles: rows of equal height about the y axis, columns of equal longitude.
/// docs/light_transport.md (43), (49).
struct DirectionGuide {
    static constexpr std::size_t kRows = 16, kColumns = 32, kCells = kRows * kColumns;
    using Shares = std::array<float, kCells>;

    float by_lobes = 1.0f; ///< probability that a direction is drawn from the lobes instead
    Shares up_to{};        ///< running sum of the cells' shares, which ends at 1
};

/// Returns the cell of a unit direction.
std::size_t cell_of(const glm::vec3& direction);

/// Returns the direction at a place within a cell.  u: [0, 1)^2.
glm::vec3 direction_in(std::size_t cell, const glm::vec2& u);

/// Draws a direction from the grid.  u: [0, 1)^2; neighbours stay neighbours within a row of cells.
glm::vec3 draw(const DirectionGuide& guide, const glm::vec2& u);

/// Returns the pdf per steradian of a unit direction that is drawn from the lobes, which have
/// `lobes_pdf` for it, or from the grid.
float mixed_pdf(const DirectionGuide& guide, float lobes_pdf, const glm::vec3& direction);

} // namespace hipmap
