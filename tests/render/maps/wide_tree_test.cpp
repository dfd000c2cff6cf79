#include "render/maps/wide_search.h"
#include "tests/render/maps/point_sets.h"
#include "tests/support/brute_force.h"
#include "tests/support/instruction_sets.h"

#include <catch2/catch.hpp>
#include <tbb/global_control.h>

#include <cstring>

using namespace hipmap;
using namespace hipmap::point_sets;

namespace {

struct OwnedTree {
    std::vector<TreePoint> points; ///< by slot
    WideTree tree;

    std::vector<std::uint32_t> photons; ///< their numbers by slot

    explicit OwnedTree(const Points& positions)
    {
        for (std::size_t i = 0; i < positions.size(); ++i)
            points.push_back({positions[i], static_cast<std::uint32_t>(i)});
        tree = build_wide_tree(points);
        for (const TreePoint& point : points)
            photons.push_back(point.photon);
    }
    /// Of equally near photons those with the lower number.
    TreeQuery query(const glm::vec3& at, std::size_t k, float radius = kFar) const
    {
        return {at, k, radius * radius, {}, photons.data()};
    }
    std::uint32_t photon(std::uint32_t slot) const { return points[slot].photon; }
};

/// What was found as brute force would list it; fails if the farthest is not the last.
std::vector<Neighbour> sorted(const OwnedTree& owner, const glm::vec3& query,
                              const FoundSlots& found)
{
    std::vector<Neighbour> out;
    for (const std::uint32_t slot : found.slots) {
        const glm::vec3 d = owner.points[slot].position - query;
        out.push_back({glm::dot(d, d), owner.photon(slot)});
    }
    if (!out.empty()) {
        const Neighbour last = out.back();
        CHECK(last.distance2 == found.farthest2);
        std::sort(out.begin(), out.end());
        CHECK(last.photon == out.back().photon);
    }
    return out;
}

/// Queries on the points, near them, and outside.
Points make_queries(const Points& points, const Place& place)
{
    Points queries = make_points(place, 77, 4);
    for (const glm::vec3& p : make_points(anywhere, 78, 2))
        queries.push_back(p);
    queries.emplace_back(3.0f, -2.0f, 0.5f);
    if (!points.empty())
        queries.push_back(points[points.size() / 2]);
    return queries;
}

/// Number of searches compared with brute force.
int compare(const Points& points, const Points& queries)
{
    const OwnedTree owner(points);
    TreeScratch scratch;
    const auto odd = [&](std::uint32_t slot) { return owner.photon(slot) % 2 == 1; };
    const auto pass = [](std::uint32_t) { return true; };
    const auto pass_odd = [](std::uint32_t i) { return i % 2 == 1; };
    int compared = 0;
    for (const glm::vec3& query : queries)
        for (const std::size_t k : {1, 2, 15, 50, 600, 30000})
            for (const float radius : {0.0f, 0.1f, kFar}) {
                const TreeQuery wanted = owner.query(query, k, radius);
                CHECK(brute_force::same(
                    sorted(owner, query, find_nearest(owner.tree, wanted, scratch)),
                    brute_force::k_nearest(points, query, k, radius, pass)));
                CHECK(brute_force::same(
                    sorted(owner, query, find_nearest(owner.tree, wanted, scratch, odd)),
                    brute_force::k_nearest(points, query, k, radius, pass_odd)));
                compared += 2;
            }
    return compared;
}

} // namespace

TEST_CASE("wide tree: every kernel matches brute force, with ties", "[maps]")
{
    with_each_instruction_set([&] {
        int compared = 0;
        for (const auto& [name, place] : kPlaces)
            for (const std::size_t count :
                 {0, 1, 2, 15, 16, 17, 49, 50, 51, 100, 255, 256, 257, 300, 1000, 4096, 5000}) {
                INFO(name << ", " << count << " photons");
                const Points points = make_points(place, count, count);
                compared += compare(points, make_queries(points, place));
            }
        CHECK(compared > 10000);
    });
    CHECK_FALSE(use_simd_target("no such target"));
}

TEST_CASE("wide tree: a search finds the same after any other", "[maps]")
{
    const Points points = make_points(kPlaces[1].second, 3, 20000);
    const OwnedTree owner(points), other(make_points(anywhere, 4, 300));
    TreeScratch used;
    for (std::uint64_t i = 0; i < 500; ++i) {
        RandomSequence random(8, RandomStream::pictures, 0, i);
        const std::size_t k = i % 3 == 0 ? 20 : 80;
        const float radius2 = i % 7 == 0 ? 1e-4f : kFar;
        const float step = i % 5 == 0 ? 1.0f : 1e-3f;
        const TreeQuery query{glm::vec3(0.5f) + step * (anywhere(random) - 0.5f), k, radius2};
        if (i % 11 == 0)
            find_nearest(other.tree, query, used);
        TreeScratch fresh;
        const FoundSlots a = find_nearest(owner.tree, query, used);
        const FoundSlots b = find_nearest(owner.tree, query, fresh);
        CHECK(std::equal(a.slots.begin(), a.slots.end(), b.slots.begin(), b.slots.end()));
        CHECK(a.farthest2 == b.farthest2);
    }
}

TEST_CASE("wide tree: a search does not take a tree for the one that was in its place", "[maps]")
{
    const Points queries = make_points(anywhere, 7, 100);
    std::vector<TreeScratch> used(queries.size());
    Points points = make_points(anywhere, 5, 20000);
    OwnedTree owner(points);
    for (std::size_t i = 0; i < queries.size(); ++i)
        find_nearest(owner.tree, {queries[i], 200}, used[i]);
    for (glm::vec3& point : points)
        point *= 0.75f;
    owner = OwnedTree(points);
    for (std::size_t i = 0; i < queries.size(); ++i) {
        const FoundSlots found = find_nearest(owner.tree, owner.query(queries[i], 20), used[i]);
        CHECK(brute_force::same(sorted(owner, queries[i], found),
                                brute_force::k_nearest(points, queries[i], 20, kFar, AcceptAll())));
    }
}

TEST_CASE("wide tree: a search that is not a number ends", "[maps]")
{
    const OwnedTree owner(make_points(anywhere, 3, 2000));
    TreeScratch scratch;
    const float nan = std::numeric_limits<float>::quiet_NaN();
    CHECK(find_nearest(owner.tree, {glm::vec3(nan), 50}, scratch).slots.empty());
    CHECK(find_nearest(owner.tree, {glm::vec3(0.5f), 50}, scratch).slots.size() == 50);
}

TEST_CASE("wide tree: the same at any thread count, every photon once, 14 bytes each", "[maps]")
{
    constexpr std::size_t kCount = 100003;
    const Points points = make_points(kPlaces[3].second, 5, kCount);
    std::vector<OwnedTree> trees;
    for (const std::size_t threads : {1, 2, 7}) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        trees.emplace_back(points);
    }
    const WideTree& first = trees[0].tree;
    for (const OwnedTree& owner : trees) {
        const WideTree& tree = owner.tree;
        REQUIRE(tree.blocks.size() == first.blocks.size());
        CHECK(std::memcmp(tree.blocks.data(), first.blocks.data(),
                          tree.blocks.size() * sizeof(PhotonBlock)) == 0);
        CHECK(std::memcmp(tree.nodes.data(), first.nodes.data(),
                          tree.nodes.size() * sizeof(BoxNode)) == 0);
    }
    CHECK(first.bytes() < 14 * kCount);
    std::vector<bool> seen(kCount, false);
    for (std::uint32_t slot = 0; slot < kCount; ++slot) {
        const std::uint32_t photon = trees[0].photon(slot);
        CHECK_FALSE(seen[photon]);
        seen[photon] = true;
        CHECK(points[photon] == first.position(slot));
    }
}

TEST_CASE("wide tree: of equally near photons those with the lower slots", "[maps]")
{
    const OwnedTree owner(make_points(kPlaces[4].second, 1, 1000)); // all in one place
    TreeScratch scratch;
    for (const std::size_t k : {1, 17, 999}) {
        const FoundSlots found = find_nearest(owner.tree, {glm::vec3(0), k}, scratch);
        REQUIRE(found.slots.size() == k);
        for (std::uint32_t i = 0; i < k; ++i)
            CHECK(found.slots[i] == i);
    }
}

TEST_CASE("wide tree: every n-th photon lies to no side of the others", "[maps]")
{
    constexpr std::size_t kCount = 1 << 14; // blocks are 1/32 wide
    const OwnedTree owner(make_points(kPlaces[1].second, 5, kCount));
    glm::dvec3 of_all(0);
    for (const TreePoint& point : owner.points)
        of_all += glm::dvec3(point.position) / double{kCount};
    for (const std::uint32_t n : {1u, 4u, 5u}) {
        const std::vector<TreePoint> some = every_nth_photon(owner.tree, n);
        REQUIRE(some.size() == (kCount + n - 1) / n);
        glm::dvec3 mean(0);
        for (const TreePoint& point : some) {
            CHECK(point.position == owner.tree.position(point.photon));
            mean += glm::dvec3(point.position) / static_cast<double>(some.size());
        }
        CHECK(glm::distance(mean, of_all) < 0.03 / 32);
    }
    CHECK(every_nth_photon(WideTree(), 4).empty());
}
