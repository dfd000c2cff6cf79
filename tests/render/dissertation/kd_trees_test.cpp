#include "common/math/random.h"
#include "render/dissertation/kd_tree.h"
#include "render/dissertation/midpoint_tree.h"
#include "tests/support/brute_force.h"

#include <catch2/catch.hpp>

#include <limits>
#include <vector>

using namespace hipmap;

namespace {

constexpr float kFar = std::numeric_limits<float>::infinity();

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

std::vector<TreePoint> numbered(const std::vector<glm::vec3>& positions)
{
    std::vector<TreePoint> points;
    for (std::size_t i = 0; i < positions.size(); ++i)
        points.push_back({positions[i], static_cast<std::uint32_t>(i)});
    return points;
}

template <typename Accept>
void offer_nearest(const BalancedTree& tree, const glm::vec3& query, const Accept& accept,
                   NeighbourHeap& heap)
{
    search_tree(tree, query, accept, heap);
}

template <typename Accept>
void offer_nearest(const InsertionTree& tree, const glm::vec3& query, const Accept& accept,
                   NeighbourHeap& heap)
{
    std::vector<PendingNode> pending;
    search_tree(tree, query, accept, heap, pending);
}

template <typename Tree, typename Accept>
bool finds_what_brute_force_does(const Tree& tree, const std::vector<glm::vec3>& points,
                                 const glm::vec3& query, std::size_t k, float radius,
                                 const Accept& accept)
{
    std::vector<Neighbour> storage(k);
    NeighbourHeap heap(storage, radius * radius);
    offer_nearest(tree, query, accept, heap);
    return brute_force::same(heap.sorted(),
                             brute_force::k_nearest(points, query, k, radius, accept));
}

/// Returns how many searches were compared.
template <typename Build>
int compare_with_brute_force(const Build& build)
{
    const auto all = [](std::uint32_t) { return true; };
    const auto odd = [](std::uint32_t i) { return i % 2 == 1; };
    int compared = 0;
    for (const std::size_t count : {0, 1, 2, 7, 8, 9, 17, 100, 1000, 20000})
        for (const float step : {0.0f, 0.25f, 2.0f}) { // the last: all points coincide
            const std::vector<glm::vec3> points = random_points(count, count, step);
            const auto tree = build(points);
            for (const glm::vec3& query : random_points(count + 1, 6, step))
                for (const std::size_t k : {1, 2, 50, 30000})
                    for (const float radius : {0.0f, 0.25f, kFar}) {
                        CHECK(finds_what_brute_force_does(tree, points, query, k, radius, all));
                        CHECK(finds_what_brute_force_does(tree, points, query, k, radius, odd));
                        compared += 2;
                    }
        }
    return compared;
}

/// Square distances of what was found, in order; the last is what it should be.
std::vector<float> distances(const FoundSlots& found, const std::vector<TreePoint>& by_slot,
                             const glm::vec3& query)
{
    std::vector<float> out;
    for (const std::uint32_t slot : found.slots) {
        const glm::vec3 d = by_slot[slot].position - query;
        out.push_back(glm::dot(d, d));
    }
    if (!out.empty())
        CHECK(out.back() == found.farthest2);
    std::sort(out.begin(), out.end());
    return out;
}

} // namespace

TEST_CASE("balanced tree: matches brute force, with ties", "[dissertation]")
{
    const auto build = [](const auto& points) { return build_balanced_tree(numbered(points)); };
    CHECK(compare_with_brute_force(build) == 4320);
}

TEST_CASE("insertion tree: matches brute force, with ties", "[dissertation]")
{
    const auto build = [](const auto& points) { return build_insertion_tree(numbered(points)); };
    CHECK(compare_with_brute_force(build) == 4320);
}

TEST_CASE("midpoint tree: matches brute force, with ties", "[dissertation]")
{
    const auto build = [](const auto& points) {
        std::vector<TreePoint> ordered = numbered(points);
        return build_midpoint_tree(ordered);
    };
    CHECK(compare_with_brute_force(build) == 4320);
}

TEST_CASE("midpoint tree: its nodes are the points, in their new order", "[dissertation]")
{
    for (const float step : {0.0f, 0.125f, 2.0f}) {
        const std::vector<glm::vec3> points = random_points(5, 5000, step);
        std::vector<TreePoint> ordered = numbered(points);
        const InsertionTree tree = build_midpoint_tree(ordered);
        std::vector<bool> seen(points.size(), false);
        for (std::size_t i = 0; i < points.size(); ++i) {
            const std::uint32_t photon = tree.nodes[i].photon;
            CHECK(ordered[i].photon == photon);
            CHECK(tree.nodes[i].position == points[photon]);
            CHECK_FALSE(seen[photon]);
            seen[photon] = true;
        }
    }
}

TEST_CASE("midpoint tree: cells are halved, however the photons lie", "[dissertation]")
{
    // Half of the photons in a corner of a thousandth of the room's length.
    std::vector<glm::vec3> points = random_points(9, 4000, 0);
    for (std::size_t i = 0; i < points.size(); i += 2)
        points[i] *= 0.001f;
    std::vector<TreePoint> ordered = numbered(points);
    const InsertionTree tree = build_midpoint_tree(ordered);
    const InsertionNode& root = tree.nodes.front();
    const int axis = static_cast<int>(root.axis);
    CHECK(root.position[axis] == Approx(0.5f).margin(0.01));
    CHECK(root.child[1] - root.child[0] > 2500); // photons below the middle
}

TEST_CASE("balanced tree: holds every point once", "[dissertation]")
{
    const std::vector<glm::vec3> points = random_points(5, 50000, 0.125f);
    const BalancedTree tree = build_balanced_tree(numbered(points));
    std::vector<bool> seen(points.size(), false);
    for (const TreePoint& point : tree.points) {
        CHECK_FALSE(seen[point.photon]);
        seen[point.photon] = true;
        CHECK(point.position == points[point.photon]);
    }
}

TEST_CASE("insertion tree: photons are found as soon as they are inserted", "[dissertation]")
{
    const std::vector<glm::vec3> points = random_points(6, 300, 0.125f);
    const auto all = [](std::uint32_t) { return true; };
    InsertionTree tree; // of an unknown box
    std::vector<glm::vec3> inserted;
    for (const TreePoint& point : numbered(points)) {
        insert(tree, point);
        inserted.push_back(point.position);
        CHECK(finds_what_brute_force_does(tree, inserted, {0.4f, 0.6f, 0.5f}, 20, kFar, all));
    }
}

TEST_CASE("kd trees: find as far photons as the wide tree, within the radius and without",
          "[dissertation]")
{
    const std::vector<glm::vec3> points = random_points(7, 5000, 0.0f);
    std::vector<TreePoint> by_wide = numbered(points);
    const WideTree wide = build_wide_tree(by_wide);
    TreeScratch wide_scratch;
    KdScratch scratch;
    const auto left = [](const std::vector<TreePoint>& by_slot) {
        return [&](std::uint32_t slot) { return by_slot[slot].position.x < 0.5f; };
    };
    for (const TreeKind kind : {TreeKind::balanced, TreeKind::unbalanced, TreeKind::midpoint}) {
        std::vector<TreePoint> by_slot = numbered(points);
        const KdTree tree = build_kd_tree(kind, by_slot);
        for (const glm::vec3& point : random_points(8, 100, 0.0f))
            for (const std::size_t k : {1, 50, 600, 9000})
                for (const float radius2 : {0.01f, kFar}) {
                    const TreeQuery query{point, k, radius2};
                    CHECK(distances(find_nearest(tree, query, scratch), by_slot, point) ==
                          distances(find_nearest(wide, query, wide_scratch), by_wide, point));
                    CHECK(distances(find_nearest(tree, query, scratch, left(by_slot)), by_slot,
                                    point) ==
                          distances(find_nearest(wide, query, wide_scratch, left(by_wide)), by_wide,
                                    point));
                }
    }
}
