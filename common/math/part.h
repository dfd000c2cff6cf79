#pragma once

#include <cstddef>

namespace hipmap {

/// A part of a range of indices: from `begin` up to `end`.
struct Part {
    std::size_t begin = 0, end = 0;

    std::size_t size() const { return end - begin; }
};

/// Returns part `index` of `count` equal parts of the indices below `size`.
inline Part part_of(std::size_t size, std::size_t index, std::size_t count)
{
    return {size * index / count, size * (index + 1) / count};
}

} // namespace hipmap
