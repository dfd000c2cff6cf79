#include "render/film/pass_set.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <random>
#include <set>

using namespace hipmap;

namespace {

/// By brute force: one pass after another.
PassSet set_of(const std::set<std::uint64_t>& passes)
{
    PassSet out;
    for (const std::uint64_t pass : passes)
        out = united(out, {{{pass, pass + 1}}});
    return out;
}

} // namespace

TEST_CASE("pass set: one form for each set, whatever the order of adding", "[film]")
{
    PassSet up, down;
    for (std::uint64_t pass = 0; pass < 10; ++pass) {
        up = united(up, {{{pass, pass + 1}}});
        down = united({{{9 - pass, 10 - pass}}}, down);
    }
    CHECK(up == PassSet{{{0, 10}}});
    CHECK(down == up);
    CHECK(is_valid(up));
    CHECK(united({{{4, 6}}}, {{{0, 2}, {8, 9}}}) == PassSet{{{0, 2}, {4, 6}, {8, 9}}});
}

TEST_CASE("pass set: counts, gaps and overlaps as of the single passes", "[film]")
{
    const std::set<std::uint64_t> passes = {0, 1, 2, 5, 6, 9, 17, 18, 19, 20};
    const PassSet set = set_of(passes);
    CHECK(count(set) == passes.size());
    for (std::uint64_t residue = 0; residue < 4; ++residue) {
        std::uint64_t found = 0;
        for (const std::uint64_t pass : passes)
            found += pass % 4 == residue ? 1 : 0;
        CHECK(count(set, 4, residue) == found);
    }
    for (std::uint64_t first = 0; first < 25; ++first) {
        std::uint64_t free = first;
        while (passes.count(free) > 0)
            ++free;
        CHECK(next_missing(set, first) == free);
        CHECK(common_pass(set, {{{first, first + 1}}}).has_value() == (passes.count(first) > 0));
    }
    CHECK(common_pass(set, {{{3, 5}, {6, 7}}}) == 6);
    CHECK_FALSE(common_pass(set, {}));
}

TEST_CASE("pass set: unions and differences as of the single passes", "[film]")
{
    std::mt19937 random(1);
    for (int round = 0; round < 200; ++round) {
        std::set<std::uint64_t> a, b, either, only_a;
        for (std::uint64_t pass = 0; pass < 12; ++pass) {
            if (random() % 2 == 0)
                a.insert(pass);
            if (random() % 3 == 0)
                b.insert(pass);
        }
        std::ranges::set_union(a, b, std::inserter(either, either.end()));
        std::ranges::set_difference(a, b, std::inserter(only_a, only_a.end()));
        CHECK(united(set_of(a), set_of(b)) == set_of(either));
        CHECK(without(set_of(a), set_of(b)) == set_of(only_a));
    }
}

TEST_CASE("pass set: ranges that are empty, out of order or that touch are not valid", "[film]")
{
    CHECK(is_valid({}));
    CHECK(is_valid({{{0, 1}, {2, 3}}}));
    CHECK_FALSE(is_valid({{{1, 1}}}));
    CHECK_FALSE(is_valid({{{2, 1}}}));
    CHECK_FALSE(is_valid({{{2, 3}, {0, 1}}}));
    CHECK_FALSE(is_valid({{{0, 1}, {1, 2}}}));
}
