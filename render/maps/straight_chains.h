#pragma once

#include "render/maps/boundary_segment.h"

#include <span>
#include <vector>

namespace hipmap {

/// Joins every straight chain of segments into one segment, so that a boundary has as many segments
/// however finely its faces are subdivided.  Two segments are joined where they alone meet, if no
/// point of the chain is farther than twice `rounding` (scene units, >= 0) from the joined segment.
/// Cost: O(n log n).
std::vector<BoundarySegment> join_straight_chains(std::span<const BoundarySegment> segments,
                                                  float rounding);

} // namespace hipmap
