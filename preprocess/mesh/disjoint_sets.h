#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace hipmap {

/// Union-find over 0..n-1 (Tarjan 1975), with path halving; n operations cost O(n log n) at worst
/// and near n in practice.  The root of a set is its lowest member, so that the order of unions
/// changes nothing.  Any number of threads may unite and ask at once (Anderson and Woll 1991): a
/// member only ever points to lower ones of its set, and only a root is given a new parent by
/// comparing.  Roots asked for while others unite may be out of date.
class DisjointSets {
  public:
    explicit DisjointSets(std::size_t count) : parent_(count)
    {
        std::iota(parent_.begin(), parent_.end(), 0u);
    }

    std::uint32_t root(std::uint32_t member)
    {
        std::uint32_t parent = load(member);
        while (parent != member) {
            const std::uint32_t above = load(parent);
            if (above != parent)
                std::atomic_ref(parent_[member]).store(above, std::memory_order_relaxed);
            member = parent;
            parent = above;
        }
        return member;
    }

    void unite(std::uint32_t a, std::uint32_t b)
    {
        for (;;) {
            a = root(a);
            b = root(b);
            if (a == b)
                return;
            if (b < a)
                std::swap(a, b);
            std::uint32_t expected = b;
            if (std::atomic_ref(parent_[b])
                    .compare_exchange_strong(expected, a, std::memory_order_relaxed))
                return;
        }
    }

  private:
    std::uint32_t load(std::uint32_t member)
    {
        return std::atomic_ref(parent_[member]).load(std::memory_order_relaxed);
    }

    std::vector<std::uint32_t> parent_;
};

} // namespace hipmap
