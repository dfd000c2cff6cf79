#pragma once

#include "render/maps/wide_sums.h"

#include <span>

namespace hipmap {

/// A tree and the powers of its photons; borrowed.
struct PoweredTree {
    const WideTree& tree;
    const PhotonPowers& powers;
};

/// Scratch memory of one thread for batches of searches; it grows and is reused.
struct BatchScratch {
    std::vector<std::uint64_t> order; ///< queries along a curve: the place there in the upper 32
                                      ///< bits, the number of the query in the lower
    std::vector<std::uint64_t> other; ///< while they are sorted
    TreeScratch search;
    TreeScratch single; ///< of queries that are answered alone
};

/// Sums the photons within one radius of each of many points: out[i] is what sum_within finds at
/// points[i], to the bit.  Points are sorted along a curve.  Those near each other are answered
/// together, a point in each lane of a vector, so that photons are read once for all of them;
/// points that lie farther apart than blocks of photons are wide are answered one by one.
/// radius2: a square, >= 0, finite.  Fewer than 2^32 points; one with a NaN finds nothing.  The
/// sums are exact and have the same bits on every processor.  Thread-safe if each thread has its
/// own scratch.  Cost: half the time of single searches where points are as dense as photons; the
/// time of single searches and of sorting the points where they are sparse.
void sum_within(const PoweredTree& of, std::span<const glm::vec3> points, float radius2,
                std::span<RadiusSum> out, BatchScratch& scratch);

} // namespace hipmap
