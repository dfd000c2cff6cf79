#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace hipmap {

/// A box to which places on a curve refer.
struct CurveBox {
    glm::vec3 low, high; ///< scene units
};

/// Sorts the numbers of points along a Morton curve through a cube over the box.  order: the place
/// on the curve, of 30 bits, in the upper 32 bits, the number in the lower; other: of the sort.
/// Points outside the box count as its nearest cell, those with a NaN as its first.  Fewer than
/// 2^32 points.  A radix sort, O(n); nothing is allocated once the arrays have grown.
void order_along_curve(const CurveBox& box, std::span<const glm::vec3> points,
                       std::vector<std::uint64_t>& order, std::vector<std::uint64_t>& other);

} // namespace hipmap
