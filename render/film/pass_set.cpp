#include "render/film/pass_set.h"

#include <algorithm>
#include <cassert>

namespace hipmap {

bool is_valid(const PassSet& set)
{
    for (std::size_t i = 0; i < set.ranges.size(); ++i) {
        const PassRange& range = set.ranges[i];
        if (range.first >= range.end || (i > 0 && range.first <= set.ranges[i - 1].end))
            return false;
    }
    return true;
}

std::uint64_t count(const PassSet& set)
{
    return count(set, 1, 0);
}

std::uint64_t count(const PassSet& set, std::uint64_t modulus, std::uint64_t residue)
{
    assert(residue < modulus);
    const auto below = [&](std::uint64_t end) { // of all passes below `end`
        return end / modulus + (end % modulus > residue ? 1 : 0);
    };
    std::uint64_t sum = 0;
    for (const PassRange& range : set.ranges)
        sum += below(range.end) - below(range.first);
    return sum;
}

std::uint64_t next_missing(const PassSet& set, std::uint64_t first)
{
    for (const PassRange& range : set.ranges)
        if (first >= range.first && first < range.end)
            return range.end;
    return first;
}

std::optional<std::uint64_t> common_pass(const PassSet& a, const PassSet& b)
{
    for (const PassRange& one : a.ranges)
        for (const PassRange& other : b.ranges)
            if (one.first < other.end && other.first < one.end)
                return std::max(one.first, other.first);
    return std::nullopt;
}

PassSet united(const PassSet& a, const PassSet& b)
{
    std::vector<PassRange> all = a.ranges;
    all.insert(all.end(), b.ranges.begin(), b.ranges.end());
    std::sort(all.begin(), all.end(),
              [](const PassRange& x, const PassRange& y) { return x.first < y.first; });
    PassSet out;
    for (const PassRange& range : all) {
        if (!out.ranges.empty() && out.ranges.back().end >= range.first)
            out.ranges.back().end = std::max(out.ranges.back().end, range.end);
        else
            out.ranges.push_back(range);
    }
    return out;
}

PassSet without(const PassSet& a, const PassSet& b)
{
    PassSet out;
    for (PassRange left : a.ranges) {
        for (const PassRange& taken : b.ranges) {
            if (taken.end <= left.first || taken.first >= left.end)
                continue;
            if (taken.first > left.first)
                out.ranges.push_back({left.first, taken.first});
            left.first = std::min(taken.end, left.end);
        }
        if (left.first < left.end)
            out.ranges.push_back(left);
    }
    return out;
}

} // namespace hipmap
