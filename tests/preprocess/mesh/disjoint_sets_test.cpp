#include "common/math/random.h"
#include "preprocess/mesh/disjoint_sets.h"

#include <catch2/catch.hpp>
#include <tbb/parallel_for.h>

using namespace hipmap;

TEST_CASE("disjoint sets: unions of several threads are those of one", "[mesh]")
{
    constexpr std::uint32_t kMembers = 20000;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> unions;
    RandomSequence random(1, RandomStream::pictures, 0, 0);
    const auto draw = [&](std::uint32_t count) {
        return static_cast<std::uint32_t>(random.next() * static_cast<float>(count));
    };
    for (std::uint32_t i = 0; i < kMembers; ++i) { // near ones and far ones
        const std::uint32_t member = draw(kMembers - 4);
        unions.emplace_back(member, i % 8 == 0 ? draw(kMembers) : member + draw(4));
    }
    DisjointSets one(kMembers), many(kMembers);
    for (const auto& [a, b] : unions)
        one.unite(a, b);
    tbb::parallel_for(std::size_t{0}, unions.size(),
                      [&](std::size_t i) { many.unite(unions[i].second, unions[i].first); });
    std::uint32_t sets = 0;
    for (std::uint32_t member = 0; member < kMembers; ++member) {
        REQUIRE(many.root(member) == one.root(member));
        REQUIRE(one.root(member) <= member);
        sets += one.root(member) == member;
    }
    CHECK(sets > 100);
    CHECK(sets < kMembers / 2);
}
