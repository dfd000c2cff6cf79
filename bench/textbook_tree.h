#pragma once

#include "render/maps/wide_tree.h"

#include <cstdint>
#include <span>

namespace hipmap {

/// A photon found near a point.
struct Neighbour {
    float distance2; ///< square of the distance, square scene units
    std::uint32_t photon;

    /// Nearer first; equally near ones by index, so that a set of k nearest is always one set.
    friend bool operator<(const Neighbour& a, const Neighbour& b)
    {
        return a.distance2 < b.distance2 || (a.distance2 == b.distance2 && a.photon < b.photon);
    }
};

/// The k nearest so far: a max-heap in memory that the caller lends.
class NeighbourHeap {
  public:
    /// storage: [k], k >= 1.  radius2: nothing farther is taken (equally far is).
    NeighbourHeap(std::span<Neighbour> storage, float radius2) : storage_(storage), bound2_(radius2)
    {
    }

    /// Nothing farther than this can get in any more.
    float bound2() const { return bound2_; }
    std::size_t size() const { return size_; }
    bool full() const { return size_ == storage_.size(); }

    void offer(const Neighbour& candidate);

    /// Orders what was found, nearest first, and returns it.  The heap is spent.
    std::span<Neighbour> sorted();

  private:
    std::span<Neighbour> storage_;
    std::size_t size_ = 0;
    float bound2_;
};

/// A balanced kd-tree without pointers over a range of points: the middle of a range is its root,
/// the halves are its subtrees.  Borrows both arrays.  Source: Jensen 2001, chapter 6.
struct TextbookTree {
    std::span<const TreePoint> points;
    std::span<const std::uint8_t> axes; ///< [points] split axis of each inner node
};

/// Orders `points` into a tree and fills `axes`; in parallel for large ranges.  O(n log n).
/// Same points in the same order, same tree.  Positions must be finite.
void order_tree(std::span<TreePoint> points, std::span<std::uint8_t> axes);

/// Ranges up to this size are not split.
inline constexpr std::size_t kLeafSize = 8;

/// Offers every photon of the tree that can matter and that `accept(photon index)` lets through.
/// point: scene units, finite.  Cost: O(k log n) typically; nothing is allocated.  Thread-safe.
template <typename Accept>
void search_tree(const TextbookTree& tree, const glm::vec3& point, const Accept& accept,
                 NeighbourHeap& heap)
{
    const auto offer = [&](const TreePoint& candidate) {
        const glm::vec3 d = candidate.position - point;
        const float distance2 = glm::dot(d, d);
        if (distance2 <= heap.bound2() && accept(candidate.photon))
            heap.offer({distance2, candidate.photon});
    };
    const auto visit = [&](const auto& self, std::size_t begin, std::size_t end) -> void {
        if (end - begin <= kLeafSize) {
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
