#pragma once

#include <algorithm>
#include <cstddef>
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

/// The k nearest so far: a max-heap in memory that the caller lends.  Source: Jensen 2001,
/// chapter 6.
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

    /// What was found, the farthest last and the others in no order.  The heap is spent.
    std::span<Neighbour> farthest_last();

  private:
    std::span<Neighbour> storage_;
    std::size_t size_ = 0;
    float bound2_;
};

} // namespace hipmap
