#pragma once

#include "render/dissertation/neighbour_heap.h"
#include "render/maps/wide_tree.h"

#include <vector>

namespace hipmap {

/// A balanced kd-tree without pointers: the middle point of a range is its root, the halves are its
/// subtrees; each range is split across its longest side.  Source: Jensen 2001, chapter 6.
/// Read-only once built: any number of threads may search.
struct BalancedTree {
    std::vector<TreePoint> points;
    std::vector<std::uint8_t> axes; ///< [points] split axis of each inner node

    std::size_t bytes() const { return points.size() * sizeof(TreePoint) + axes.size(); }
};

/// Builds the tree in O(n log n), in parallel for large ranges.  Same points, same tree, at any
/// thread count. Positions must be finite.  No points: a tree that finds nothing.
BalancedTree build_balanced_tree(std::vector<TreePoint> points);

/// The largest range that is not split.
inline constexpr std::size_t kBalancedLeaf = 8;

/// Offers to `accept(photon)` every photon of the tree that can matter, and keeps those accepted.
/// point: scene units.  Cost: O(k log n) typically; nothing is allocated.  Thread-safe.
template <typename Accept>
void search_tree(const BalancedTree& tree, const glm::vec3& point, const Accept& accept,
                 NeighbourHeap& heap)
{
    const auto offer = [&](const TreePoint& candidate) {
        const glm::vec3 d = candidate.position - point;
        const float distance2 = glm::dot(d, d);
        if (distance2 <= heap.bound2() && accept(candidate.photon))
            heap.offer({distance2, candidate.photon});
    };
    const auto visit = [&](const auto& self, std::size_t begin, std::size_t end) -> void {
        if (end - begin <= kBalancedLeaf) {
            for (std::size_t i = begin; i < end; ++i)
                offer(tree.points[i]);
            return;
        }
        const std::size_t middle = begin + (end - begin) / 2;
        const int axis = tree.axes[middle];
        const float across = point[axis] - tree.points[middle].position[axis];
        if (across < 0)
            self(self, begin, middle);
        else
            self(self, middle + 1, end);
        // Rounding is monotonic: a photon beyond the plane is never nearer than this.
        if (!(across * across <= heap.bound2()))
            return;
        offer(tree.points[middle]);
        if (across < 0)
            self(self, middle + 1, end);
        else
            self(self, begin, middle);
    };
    visit(visit, 0, tree.points.size());
}

} // namespace hipmap
