#include "common/math/split_at_rank.h"

#include <catch2/catch.hpp>
#include <rapidcheck/catch.h>

#include <vector>

using namespace hipmap;

TEST_CASE("split_at_rank: the least items come first, whatever their order", "[math][property]")
{
    rc::prop("as sorting does", [] {
        const int count = *rc::gen::inRange(0, 9000);
        const int period = *rc::gen::inRange(1, 9000); // few values, many rows, or one rise
        const int sign = *rc::gen::element(-1, 1);
        std::vector<int> items;
        for (int i = 0; i < count; ++i)
            items.push_back(sign * (i * 7919 % period));
        std::vector<int> sorted = items;
        std::ranges::sort(sorted);
        const auto rank = *rc::gen::inRange<std::size_t>(0, items.size() + 1);
        split_at_rank(std::span(items), rank, [](int a, int b) { return a < b; });
        std::sort(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(rank));
        std::sort(items.begin() + static_cast<std::ptrdiff_t>(rank), items.end());
        RC_ASSERT(items == sorted);
    });
}
