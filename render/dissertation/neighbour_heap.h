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

    /// Orders by distance, and equally near photons by index, so that the set of k nearest is
    /// unique.
    friend bool operator<(const Neighbour& a, const Neighbour& b)
    {
        return a.distance2 < b.distance2 || (a.distance2 == b.distance2 && a.photon < b.photon);
    }
};

/// Keeps the k nearest photons so far: a max-heap in memory that the caller lends.  Source: Jensen
/// 2001, chapter 6.
class NeighbourHeap {
  public:
    /// Starts an empty heap.  storage: [k], k >= 1.  radius2: squared radius; photons at or beyond
    /// it are not taken.
    NeighbourHeap(std::span<Neighbour> storage, float radius2) : storage_(storage), bound2_(radius2)
    {
    }

    /// Returns the squared distance from which on no photon can enter any more.
    float bound2() const { return bound2_; }
    std::size_t size() const { return size_; }
    bool full() const { return size_ == storage_.size(); }

    void offer(const Neighbour& candidate);

    /// Sorts what was found, nearest first, and returns it.  The heap must not be used afterwards.
    std::span<Neighbour> sorted();

    /// Returns what was found, the farthest last and the others in no order.  The heap must not be
    /// used afterwards.
    std::span<Neighbour> farthest_last();

  private:
    std::span<Neighbour> storage_;
    std::size_t size_ = 0;
    float bound2_;
};

} // namespace hipmap
