#pragma once

#include "common/math/random.h"

#include <cstdint>
#include <span>
#include <vector>

namespace hipmap {

/// A density over the unit cube of primary samples, by which the starts of light paths are drawn
/// where they matter (Guo, Bauszat, Bikker and Eisemann 2018).  It is even within the leaves of a
/// binary tree whose nodes halve their cell.  docs/light_transport.md (41).
struct PrimaryDensity {
    struct Node {
        std::uint32_t lower = 0; ///< node of the lower half, before that of the upper; 0: a leaf
        std::uint32_t dimension = 0;
        float lower_share = 0.5f; ///< probability of the lower half
        float middle = 0;         ///< where the upper half begins, along the dimension
    };
    std::vector<Node> nodes; ///< the root first; none: even over the cube
};

/// A point drawn from a density.
struct DrawnPrimary {
    PrimarySample at;
    float density = 1.0f; ///< above zero
};

/// Turns a point that is even over the cube into one that follows the density; neighbours stay
/// neighbours, so that samples keep their stratification.
DrawnPrimary draw(const PrimaryDensity& density, const PrimarySample& even);

/// Returns the density at a point of the cube.
double density_at(const PrimaryDensity& density, const PrimarySample& at);

/// A point of the cube whose worth is known.
struct PrimaryWorth {
    PrimarySample at;
    double worth = 0;
    double density = 1; ///< by which it was drawn, times the number of points drawn
};

/// A density that is not yet mixed with an even part.
struct LearntDensity {
    PrimaryDensity density;
    std::vector<double> node_share; ///< [nodes] of the whole
    double worth = 0;               ///< of the cube: the sum of that of its cells
};

/// Learns where worth is from points drawn by any density.  The worth of a cell is the root of its
/// volume times the mean square of worth in it: samples in proportion to it estimate the sum of all
/// worth with the least variance.  A cell is halved while its points show that worth is uneven
/// there.  Where less than `alike` points of equal worth would hold all, a power of worth below one
/// decides, which leads on towards them.  No point with worth: no node, and worth zero.  O(points
/// log points).
LearntDensity learn_density(std::span<const PrimaryWorth> points, double alike);

/// Returns the density of which a share `even` is spread evenly.  It stays below 512.
PrimaryDensity mixed_with_even(const LearntDensity& learnt, double even);

} // namespace hipmap
