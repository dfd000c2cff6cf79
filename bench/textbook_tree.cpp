#include "bench/textbook_tree.h"

#include "common/math/bounds.h"

#include <tbb/parallel_invoke.h>

#include <algorithm>

namespace hipmap {

namespace {

/// Below this a range is ordered by one thread.
constexpr std::size_t kParallelSize = 1 << 14;

int widest_axis(std::span<const TreePoint> points)
{
    Bounds<glm::vec3> box;
    for (const TreePoint& point : points)
        box.add(point.position);
    const glm::vec3 extent = box.extent();
    if (extent.x >= extent.y && extent.x >= extent.z)
        return 0;
    return extent.y >= extent.z ? 1 : 2;
}

} // namespace

void NeighbourHeap::offer(const Neighbour& candidate)
{
    Neighbour* const begin = storage_.data();
    if (!full()) {
        begin[size_++] = candidate;
        std::push_heap(begin, begin + size_);
        if (full())
            bound2_ = begin->distance2;
        return;
    }
    if (!(candidate < *begin))
        return;
    std::pop_heap(begin, begin + size_);
    begin[size_ - 1] = candidate;
    std::push_heap(begin, begin + size_);
    bound2_ = begin->distance2;
}

std::span<Neighbour> NeighbourHeap::sorted()
{
    const std::span<Neighbour> found = storage_.first(size_);
    std::sort_heap(found.begin(), found.end());
    return found;
}

void order_tree(std::span<TreePoint> points, std::span<std::uint8_t> axes)
{
    if (points.size() <= kLeafSize)
        return;
    const int axis = widest_axis(points);
    const std::size_t middle = points.size() / 2;
    std::nth_element(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(middle),
                     points.end(), [axis](const TreePoint& a, const TreePoint& b) {
                         const float x = a.position[axis], y = b.position[axis];
                         return x < y || (x == y && a.photon < b.photon);
                     });
    axes[middle] = static_cast<std::uint8_t>(axis);
    const auto low = [&] { order_tree(points.first(middle), axes.first(middle)); };
    const auto high = [&] { order_tree(points.subspan(middle + 1), axes.subspan(middle + 1)); };
    if (points.size() >= kParallelSize) {
        tbb::parallel_invoke(low, high);
    } else {
        low();
        high();
    }
}

} // namespace hipmap
