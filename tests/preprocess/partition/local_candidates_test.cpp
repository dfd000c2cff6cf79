#include "preprocess/partition/local_candidates.h"
#include "tests/support/tiny_meshes.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <limits>
#include <numbers>

using namespace hipmap;

namespace {

using Corners = std::array<glm::dvec3, 3>;

double distance_to_segment(const glm::dvec3& x, const glm::dvec3& a, const glm::dvec3& b)
{
    const double t = std::clamp(glm::dot(x - a, b - a) / glm::dot(b - a, b - a), 0.0, 1.0);
    return glm::length(x - (a + t * (b - a)));
}

/// Largest distance from the nearest chosen edge over a grid of `steps` points a side.
double sampled_reach(const Corners& p, const std::array<bool, 3>& connected, int steps)
{
    double reach = 0;
    for (int i = 0; i <= steps; ++i)
        for (int j = 0; i + j <= steps; ++j) {
            const double u = static_cast<double>(i) / steps;
            const double v = static_cast<double>(j) / steps;
            const glm::dvec3 x = p[0] * (1 - u - v) + p[1] * u + p[2] * v;
            double nearest = std::numeric_limits<double>::infinity();
            for (int c = 0; c < 3; ++c)
                if (connected[c])
                    nearest = std::min(nearest, distance_to_segment(x, p[c], p[(c + 1) % 3]));
            reach = std::max(reach, nearest);
        }
    return reach;
}

LocalCandidates candidates_of(const TriangleMesh& mesh, const std::vector<EdgeClass>& classes,
                              std::vector<MapId> maps)
{
    const auto count = static_cast<std::uint32_t>(*std::ranges::max_element(maps) + 1);
    return find_local_candidates(mesh, classes, {std::move(maps), count});
}

} // namespace

TEST_CASE("reach_of: known triangles", "[partition]")
{
    const Corners right{{{0, 0, 0}, {4, 0, 0}, {0, 3, 0}}};
    CHECK(reach_of(right, {true, true, true}) == Approx(1));
    CHECK(reach_of(right, {true, false, false}) == Approx(3));
    CHECK(reach_of(right, {false, true, false}) == Approx(2.4));
    CHECK(reach_of(right, {true, false, true}) == Approx(12.0 / 7)); // on the diagonal x = y
    CHECK(std::isinf(reach_of(right, {false, false, false})));
    const Corners obtuse{{{0, 0, 0}, {1, 0, 0}, {3, 4, 0}}};
    CHECK(reach_of(obtuse, {true, false, false}) == Approx(std::sqrt(20.0))); // to corner 1
}

TEST_CASE("reach_of: no sampled point of a triangle is farther, and some are as far", "[partition]")
{
    constexpr int kSteps = 200;
    for (std::uint64_t seed = 0; seed < 150; ++seed) {
        RandomSequence random(seed, RandomStream::pictures, 0, 0);
        Corners p;
        for (glm::dvec3& corner : p)
            for (int axis = 0; axis < 3; ++axis)
                corner[axis] = random.next() * (axis == 1 ? 0.2 : 1.0);
        const double longest = std::max(
            {glm::length(p[1] - p[0]), glm::length(p[2] - p[1]), glm::length(p[0] - p[2])});
        for (int mask = 1; mask < 8; ++mask) {
            const std::array<bool, 3> connected{(mask & 1) != 0, (mask & 2) != 0, (mask & 4) != 0};
            const double sampled = sampled_reach(p, connected, kSteps);
            const double reach = reach_of(p, connected);
            REQUIRE(reach >= sampled * (1 - 1e-9));
            REQUIRE(reach <= sampled + longest / kSteps); // distances change as slowly as points
        }
    }
}

TEST_CASE("find_local_candidates: a face alone in its map needs no local one", "[partition]")
{
    using enum EdgeClass;
    const std::vector<EdgeClass> classes(6, border);
    const LocalCandidates locals = candidates_of(tiny::quad(), classes, {0, 1});
    CHECK(locals.candidate == std::vector<std::uint8_t>{0, 0});
    CHECK(std::isinf(locals.reach[0]));
}

TEST_CASE("find_local_candidates: reach against the filter radius of the fewest photons",
          "[partition]")
{
    using enum EdgeClass;
    // One connected edge of length b, height h: worth it if h > sqrt(b h / 2 / (10 pi)), that is if
    // h / b > 1 / (20 pi).
    for (const auto& [height, worth] : {std::pair(0.99f, 0), std::pair(1.01f, 1)}) {
        const float h = height / (20 * std::numbers::pi_v<float>);
        const TriangleMesh mesh = tiny::make_mesh(
            {{0, 0, 0}, {1, 0, 0}, {0.5f, h, 0}, {0.5f, -1, 0}}, {{0, 1, 2}, {1, 0, 3}});
        const std::vector<EdgeClass> classes{connected, border, border, connected, border, border};
        const LocalCandidates locals = candidates_of(mesh, classes, {0, 0});
        CHECK(locals.reach[0] == Approx(h));
        CHECK(locals.candidate[0] == worth);
        CHECK(locals.candidate[1] == 1);
    }
}

TEST_CASE("find_local_candidates: a degenerate face has no reach and no local map", "[partition]")
{
    std::vector<EdgeClass> classes(12, EdgeClass::border);
    std::fill_n(classes.begin() + 3, 6, EdgeClass::degenerate);
    SharedMaps maps{{0, kNone, kNone, 1}, 2};
    const LocalCandidates locals = find_local_candidates(tiny::degenerate(), classes, maps);
    CHECK(locals.reach[1] == 0);
    CHECK(locals.reach[2] == 0);
    CHECK(locals.candidate[1] == 0);
}
