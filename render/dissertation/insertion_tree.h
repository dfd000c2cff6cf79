#pragma once

#include "common/math/bounds.h"
#include "render/dissertation/neighbour_heap.h"
#include "render/maps/wide_tree.h"

#include <array>
#include <vector>

namespace hipmap {

inline constexpr std::uint32_t kNoNode = ~std::uint32_t{0};

/// A photon of an insertion tree and its children; kNoNode: none.
struct InsertionNode {
    glm::vec3 position;
    std::uint32_t photon;
    std::array<std::uint32_t, 2> child{kNoNode, kNoNode}; ///< lower on the axis; not lower
    std::uint32_t same = kNoNode;                         ///< the next photon in the same place
    std::uint32_t axis = 0;
};

/// An unbalanced kd-tree into which photons can be inserted one by one at any time.  A photon
/// splits the cell it falls into, across the axis on which it cuts it most evenly. The dissertation
/// names it as the rival of balanced trees (Guenther, Wald and Slusallek 2004). Any number of
/// threads may search while none inserts.
struct InsertionTree {
    Bounds<glm::vec3> box;            ///< of the photons to come; a wrong one costs time only
    std::vector<InsertionNode> nodes; ///< by order of insertion; the first is the root

    std::size_t bytes() const { return nodes.size() * sizeof(InsertionNode); }
};

/// Inserts a point; position: finite, scene units.  O(log n) for photons in random order, O(n) for
/// sorted ones.
void insert(InsertionTree& tree, const TreePoint& point);

/// Inserts all points in their order.  No points: a tree that finds nothing.
InsertionTree build_insertion_tree(std::span<const TreePoint> points);

/// A subtree that a search has still to look at.
struct PendingNode {
    std::uint32_t node;
    float distance2; ///< nothing in it is nearer
};

/// Offers to `accept(photon)` every photon of the tree that can matter, and keeps those accepted.
/// point: scene units.  pending: memory that the caller lends.  Cost: O(k log n) typically.
/// Thread-safe.
template <typename Accept>
void search_tree(const InsertionTree& tree, const glm::vec3& point, const Accept& accept,
                 NeighbourHeap& heap, std::vector<PendingNode>& pending)
{
    pending.clear();
    if (!tree.nodes.empty())
        pending.push_back({0, 0.0f});
    while (!pending.empty()) {
        const PendingNode next = pending.back();
        pending.pop_back();
        if (!(next.distance2 <= heap.bound2()))
            continue;
        for (std::uint32_t at = next.node; at != kNoNode;) {
            const InsertionNode& node = tree.nodes[at];
            const glm::vec3 d = node.position - point;
            const float distance2 = glm::dot(d, d);
            if (distance2 <= heap.bound2())
                for (std::uint32_t i = at; i != kNoNode; i = tree.nodes[i].same)
                    if (accept(tree.nodes[i].photon))
                        heap.offer({distance2, tree.nodes[i].photon});
            const float across =
                point[static_cast<int>(node.axis)] - node.position[static_cast<int>(node.axis)];
            const bool above = across >= 0;
            if (const std::uint32_t far = node.child[above ? 0 : 1]; far != kNoNode)
                pending.push_back({far, across * across});
            at = node.child[above ? 1 : 0];
        }
    }
}

} // namespace hipmap
