#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace hipmap {

/// Union-find over 0..n-1 (Tarjan 1975), with path halving; n operations cost O(n log n) at worst
/// and near n in practice.  The root of a set is its lowest member, so that the order of unions
/// changes nothing.  One thread.
class DisjointSets {
  public:
    explicit DisjointSets(std::size_t count) : parent_(count)
    {
        std::iota(parent_.begin(), parent_.end(), 0u);
    }

    std::uint32_t root(std::uint32_t member)
    {
        while (parent_[member] != member) {
            parent_[member] = parent_[parent_[member]];
            member = parent_[member];
        }
        return member;
    }

    void unite(std::uint32_t a, std::uint32_t b)
    {
        a = root(a);
        b = root(b);
        if (b < a)
            std::swap(a, b);
        parent_[b] = a;
    }

  private:
    std::vector<std::uint32_t> parent_;
};

} // namespace hipmap
