#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

namespace hipmap {

/// Returns an item near the one of the given rank, chosen from evenly spaced samples.
template <typename Item, typename Less>
Item pivot_near(std::span<const Item> items, std::size_t rank, const Less& less)
{
    std::array<Item, 31> samples;
    const std::size_t count = items.size() > 4096 ? 31 : items.size() > 256 ? 7 : 3;
    for (std::size_t i = 0; i < count; ++i)
        samples[i] = items[i * (items.size() - 1) / (count - 1)];
    const auto pivot = samples.begin() + static_cast<std::ptrdiff_t>(count * rank / items.size());
    std::nth_element(samples.begin(), pivot, samples.begin() + static_cast<std::ptrdiff_t>(count),
                     less);
    return *pivot;
}

/// Moves the items less than the pivot to the front and returns how many they are.  The loop does
/// not branch on the comparison, which no processor could predict.
template <typename Item, typename Less>
std::size_t move_to_front(std::span<Item> items, const Item& pivot, const Less& less)
{
    std::size_t front = 0;
    for (Item& item : items) {
        const Item moved = item;
        item = items[front];
        items[front] = moved;
        front += less(moved, pivot) ? 1 : 0;
    }
    return front;
}

/// Orders items so that the least `rank` come first, as std::nth_element does, in about half its
/// time. rank: at most items.size().  less: a total order without branches of its own. The same
/// items in the same order give the same order.  Linear on average, one thread.
template <typename Item, typename Less>
void split_at_rank(std::span<Item> items, std::size_t rank, const Less& less)
{
    constexpr std::size_t kFew = 16;
    constexpr int kMostRounds = 32; // pivots of any use need far fewer
    for (int round = 0; items.size() > kFew && round < kMostRounds; ++round) {
        if (rank == 0 || rank == items.size())
            return;
        const Item pivot = pivot_near(std::span<const Item>(items), rank, less);
        const std::size_t lower = move_to_front(items, pivot, less);
        if (rank <= lower) {
            items = items.first(lower);
        } else {
            items = items.subspan(lower);
            rank -= lower;
        }
    }
    std::nth_element(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(rank), items.end(),
                     less);
}

} // namespace hipmap
