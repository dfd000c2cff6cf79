#pragma once

#include "render/maps/fold_tree.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace hipmap {

/// Whose area is asked for: the surface's own, or that of its projection into the query's plane.
enum class AreaOf { surface, projection };

/// A point of a map that folds, where its faces are stored.
struct FoldQuery {
    std::uint32_t fold; ///< place among the maps that fold
    glm::vec3 point;    ///< scene units
    glm::vec3 normal;   ///< unit, of the point's face
    AreaOf of;
};

inline constexpr std::size_t kMostFoldRadii = 3;
/// By radius, square scene units.
using FoldAreas = std::array<double, kMostFoldRadii>;

/// Returns how much of a map that folds lies within each radius of a point and looks to its side,
/// docs/visible_area.md (A9).  radii: at most kMostFoldRadii, >= 0, finite.  Zero where rounding
/// has put the point off its map.  The same bits on every processor.  Thread-safe.  Cost: at most
/// kMostOpenFolds nodes and blocks, however many faces lie within the radii.
FoldAreas fold_areas(const FoldTrees& trees, const FoldQuery& query, std::span<const float> radii);

inline constexpr std::size_t kMostOpenFolds = 256;

} // namespace hipmap
