#include "common/math/random.h"
#include "preprocess/partition/polygon_distance.h"

#include <catch2/catch.hpp>

#include <limits>

using namespace hipmap;

namespace {

using Triangle = std::array<glm::dvec3, 3>;

ConvexPolygon polygon(const Triangle& t)
{
    return {t, glm::cross(t[1] - t[0], t[2] - t[0])};
}

Triangle random_triangle(RandomSequence& random)
{
    Triangle t;
    for (glm::dvec3& p : t)
        for (int axis = 0; axis < 3; ++axis)
            p[axis] = random.next();
    return t;
}

/// Points of a convex polygon: all mixtures of its corners on a grid of its fan of triangles.
std::vector<glm::dvec3> points_of(const ConvexPolygon& polygon, int steps)
{
    std::vector<glm::dvec3> out;
    const auto p = polygon.points();
    for (std::size_t i = 1; i + 1 < p.size(); ++i)
        for (int u = 0; u <= steps; ++u)
            for (int v = 0; u + v <= steps; ++v)
                out.push_back(p[0] + (p[i] - p[0]) * (double(u) / steps) +
                              (p[i + 1] - p[0]) * (double(v) / steps));
    return out;
}

double sampled_distance(const ConvexPolygon& a, const ConvexPolygon& b, int steps)
{
    double least = std::numeric_limits<double>::infinity();
    for (const glm::dvec3& p : points_of(a, steps))
        for (const glm::dvec3& q : points_of(b, steps))
            least = std::min(least, glm::length(p - q));
    return least;
}

} // namespace

TEST_CASE("polygon distance: known triangles", "[partition]")
{
    const ConvexPolygon base = polygon({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}});
    const auto to = [&](const Triangle& t) { return distance(base, polygon(t)); };
    CHECK(to({{{0, 0, 2}, {1, 0, 2}, {0, 1, 2}}}) == Approx(2));       // parallel, above
    CHECK(to({{{.2, .2, 1}, {.2, .2, 3}, {.2, .3, 3}}}) == Approx(1)); // corner over the inside
    CHECK(to({{{.2, .2, 1}, {.2, .2, -1}, {3, 3, 0}}}) == 0);          // goes through
    CHECK(to({{{0, 0, 0}, {-1, 0, 0}, {0, -1, 1}}}) == 0);             // one corner in common
    CHECK(to({{{2, 0, 0}, {3, 0, 0}, {2, 1, 0}}}) == Approx(1));       // in one plane, apart
    CHECK(to({{{-1, -1, 1}, {3, -1, 1}, {.3, -1, 3}}}) == Approx(std::sqrt(2.0))); // edge to edge
}

TEST_CASE("polygon distance: no sampled pair of points is nearer, and some are as near",
          "[partition]")
{
    constexpr int kSteps = 12;
    RandomSequence random(5, RandomStream::pictures, 0, 0);
    for (int i = 0; i < 300; ++i) {
        const ConvexPolygon a = polygon(random_triangle(random));
        ConvexPolygon b = polygon(random_triangle(random));
        if (i % 2)
            b.clip({0.5, 0.5, 0.5}, glm::normalize(glm::dvec3(1, random.next(), 0)), 0);
        if (b.points().size() < 3)
            continue;
        const double exact = distance(a, b);
        const double sampled = sampled_distance(a, b, kSteps);
        REQUIRE(exact <= sampled * (1 + 1e-12));
        REQUIRE(exact >= sampled - 2 * std::sqrt(3.0) / kSteps);
        REQUIRE(distance(b, a) == Approx(exact));
    }
}

TEST_CASE("polygon clip: what lies in front stays, what only touches goes", "[partition]")
{
    const Triangle t{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
    ConvexPolygon all = polygon(t), corner = polygon(t), none = polygon(t);
    all.clip({0, -1, 0}, {0, 1, 0}, 0.5);
    CHECK(all.points().size() == 3);
    corner.clip({0, 0, 0}, {0, 1, 0}, 0.5);
    CHECK(corner.points().size() == 3);
    for (const glm::dvec3& p : corner.points())
        CHECK(p.y >= 0.5);
    none.clip({0, 0, 0}, {0, -1, 0}, 0);
    CHECK(none.points().empty());
}
