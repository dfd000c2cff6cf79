#include "bench/textbook_tree.h"
#include "common/math/random.h"
#include "tests/support/brute_force.h"

#include <catch2/catch.hpp>

#include <limits>
#include <vector>

using namespace hipmap;

namespace {

constexpr float kFar = std::numeric_limits<float>::infinity();

/// A tree that owns its arrays.
struct OwnedTree {
    std::vector<TreePoint> points;
    std::vector<std::uint8_t> axes;

    explicit OwnedTree(const std::vector<glm::vec3>& positions) : axes(positions.size())
    {
        for (std::size_t i = 0; i < positions.size(); ++i)
            points.push_back({positions[i], static_cast<std::uint32_t>(i)});
        order_tree(points, axes);
    }
    TextbookTree view() const { return {points, axes}; }
};

/// step > 0: coordinates are multiples of it, so that many distances are equal.
std::vector<glm::vec3> random_points(std::uint64_t seed, std::size_t count, float step)
{
    std::vector<glm::vec3> points;
    for (std::size_t i = 0; i < count; ++i) {
        RandomSequence random(seed, RandomStream::pictures, 0, i);
        glm::vec3 p(random.next(), random.next(), random.next());
        if (step > 0)
            p = glm::floor(p / step) * step;
        points.push_back(p);
    }
    return points;
}

template <typename Accept>
std::vector<Neighbour> search(const TextbookTree& tree, const glm::vec3& query, std::size_t k,
                              float radius, const Accept& accept)
{
    std::vector<Neighbour> storage(k);
    NeighbourHeap heap(storage, radius * radius);
    search_tree(tree, query, accept, heap);
    const std::span<Neighbour> found = heap.sorted();
    return {found.begin(), found.end()};
}

} // namespace

TEST_CASE("textbook tree: matches brute force, with ties", "[bench]")
{
    const auto all = [](std::uint32_t) { return true; };
    const auto odd = [](std::uint32_t i) { return i % 2 == 1; };
    int compared = 0;
    for (const std::size_t count : {0, 1, 2, 7, 8, 9, 17, 100, 1000, 20000}) {
        for (const float step : {0.0f, 0.25f, 2.0f}) { // the last: all points coincide
            const std::vector<glm::vec3> points = random_points(count, count, step);
            const OwnedTree tree(points);
            const std::vector<glm::vec3> queries = random_points(count + 1, 6, step);
            for (const glm::vec3& query : queries)
                for (const std::size_t k : {1, 2, 50, 30000})
                    for (const float radius : {0.0f, 0.25f, kFar}) {
                        CHECK(brute_force::same(
                            search(tree.view(), query, k, radius, all),
                            brute_force::k_nearest(points, query, k, radius, all)));
                        CHECK(brute_force::same(
                            search(tree.view(), query, k, radius, odd),
                            brute_force::k_nearest(points, query, k, radius, odd)));
                        compared += 2;
                    }
        }
    }
    CHECK(compared == 4320);
}

TEST_CASE("textbook tree: holds every point once", "[bench]")
{
    const std::vector<glm::vec3> points = random_points(5, 50000, 0.125f);
    const OwnedTree tree(points);
    std::vector<bool> seen(points.size(), false);
    for (const TreePoint& point : tree.points) {
        CHECK_FALSE(seen[point.photon]);
        seen[point.photon] = true;
        CHECK(point.position == points[point.photon]);
    }
}
