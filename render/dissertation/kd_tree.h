#pragma once

#include "render/dissertation/balanced_tree.h"
#include "render/dissertation/dissertation.h"
#include "render/dissertation/insertion_tree.h"
#include "render/maps/wide_search.h"

namespace hipmap {

/// A map's photons in a tree of the dissertation's time, of one of two forms.  A photon's slot is
/// its place in the order of the tree's array.
struct KdTree {
    BalancedTree balanced;
    InsertionTree unbalanced;

    std::size_t size() const { return balanced.points.size() + unbalanced.nodes.size(); }
    /// Returns the bytes of the arrays.
    std::size_t bytes() const { return balanced.bytes() + unbalanced.bytes(); }
};

/// Sorts `points` by slot and builds their tree; kind: not wide.  Cost, empty input and threads as
/// for the chosen tree.
KdTree build_kd_tree(TreeKind kind, std::span<TreePoint> points);

/// Scratch memory of one thread for its searches; it grows and is reused.
struct KdScratch {
    std::vector<Neighbour> heap;
    std::vector<PendingNode> pending;
    std::vector<std::uint32_t> found;
};

/// Finds the k nearest photons that `accept(slot)` lets through, fewer if there are no more within
/// the radius; of equally near ones those with the lower slot.  Finds the photons that a WideTree
/// finds, by other slots.  Jensen's search with a max-heap, which does not use the previous search.
/// Thread-safe with a scratch for each thread.
template <typename Accept = AcceptAll>
FoundSlots find_nearest(const KdTree& tree, const TreeQuery& query, KdScratch& scratch,
                        const Accept& accept = {})
{
    const std::size_t most = std::min(query.photons, tree.size());
    if (most == 0)
        return {};
    scratch.heap.resize(std::max(scratch.heap.size(), most));
    scratch.found.resize(scratch.heap.size());
    NeighbourHeap heap(std::span(scratch.heap).first(most), query.radius2);
    search_tree(tree.balanced, query.point, accept, heap);
    search_tree(tree.unbalanced, query.point, accept, heap, scratch.pending);
    const std::span<const Neighbour> found = heap.farthest_last();
    for (std::size_t i = 0; i < found.size(); ++i)
        scratch.found[i] = found[i].photon;
    return {std::span(scratch.found).first(found.size()),
            found.empty() ? 0.0f : found.back().distance2};
}

} // namespace hipmap
