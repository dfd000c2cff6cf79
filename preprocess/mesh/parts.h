#pragma once

#include "common/math/part.h"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>

namespace hipmap {

/// Returns into how many parts to divide work of which each part goes through all items and keeps
/// its own: one for each thread up to 16, and one alone for few items.
inline std::size_t parts_for(std::size_t items)
{
    constexpr std::size_t kMostParts = 16;
    constexpr std::size_t kLeastItems = 1 << 16;
    const std::size_t threads =
        tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
    return std::clamp<std::size_t>(items / kLeastItems, 1, std::min(threads, kMostParts));
}

/// Calls work(index) for each part, a thread for each.
template <typename Work>
void for_each_part(std::size_t count, const Work& work)
{
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, count, 1),
        [&](const tbb::blocked_range<std::size_t>& range) {
            for (std::size_t part = range.begin(); part < range.end(); ++part)
                work(part);
        },
        tbb::simple_partitioner());
}

} // namespace hipmap
