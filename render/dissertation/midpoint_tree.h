#pragma once

#include "render/dissertation/insertion_tree.h"

namespace hipmap {

/// Builds an unbalanced kd-tree of all points at once: a cell is split across its longest side by
/// the first photon beyond its middle, so that cells halve and not the photons in them.
/// Orders `points` as the tree's nodes.  O(n log n) for photons that lie evenly.  Same points, same
/// tree.  Positions must be finite.  No points: a tree that finds nothing.
InsertionTree build_midpoint_tree(std::span<TreePoint> points);

} // namespace hipmap
