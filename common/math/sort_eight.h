#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

namespace hipmap {

/// Sorts eight numbers, ascending, by a network of 19 comparisons, which has no branches.  No
/// network needs fewer comparisons (Knuth 1998, section 5.3.4).
inline void sort_eight(std::array<float, 8>& values)
{
    const auto order = [&](std::size_t low, std::size_t high) {
        const float a = values[low], b = values[high];
        values[low] = std::min(a, b);
        values[high] = std::max(a, b);
    };
    order(0, 2), order(1, 3), order(4, 6), order(5, 7);
    order(0, 4), order(1, 5), order(2, 6), order(3, 7);
    order(0, 1), order(2, 3), order(4, 5), order(6, 7);
    order(2, 4), order(3, 5), order(1, 4), order(3, 6);
    order(1, 2), order(3, 4), order(5, 6);
}

} // namespace hipmap
