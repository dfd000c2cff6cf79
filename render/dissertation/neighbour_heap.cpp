#include "render/dissertation/neighbour_heap.h"

namespace hipmap {

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

std::span<Neighbour> NeighbourHeap::farthest_last()
{
    const std::span<Neighbour> found = storage_.first(size_);
    std::pop_heap(found.begin(), found.end());
    return found;
}

} // namespace hipmap
