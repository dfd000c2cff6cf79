#pragma once

#include "render/maps/wide_search.h"

namespace hipmap::tree_search {

/// Fills blocks and rows with at least k photons near the point, of which the k-th nearest bounds
/// the k-th of all, and returns their number.  query.from has more than k photons.
std::size_t collect_near(const WideTree& tree, const TreeQuery& query, TreeScratch& scratch);

/// The k-th smallest of the collected distances up to bounds.high2, of which there are `inside` >=
/// k.
float kth_distance2(std::size_t k, const Bounds2& bounds, std::size_t inside, TreeScratch& scratch);

/// The greatest collected distance up to radius2; zero if there is none.
float greatest_distance2(float radius2, const TreeScratch& scratch);

/// Puts the collected slots nearer than `farthest2` into scratch.found, and those as far into
/// scratch.ties.
struct Emitted {
    std::size_t nearer, as_far;
};
Emitted emit_nearest(float farthest2, TreeScratch& scratch);

} // namespace hipmap::tree_search
