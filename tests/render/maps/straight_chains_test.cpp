#include "render/maps/straight_chains.h"
#include "tests/render/maps/flat_walls.h"

#include <catch2/catch.hpp>

using namespace hipmap;
using namespace hipmap::flat_walls;

namespace {

/// A chain through points on the way round a polygon of given corners, each side in `parts`.
Segments subdivided(const std::vector<glm::vec3>& corners, int parts)
{
    std::vector<glm::vec3> points;
    for (std::size_t i = 0; i < corners.size(); ++i)
        for (int part = 0; part < parts; ++part)
            points.push_back(glm::mix(corners[i], corners[(i + 1) % corners.size()],
                                      float(part) / float(parts)));
    Segments out;
    for (std::size_t i = 0; i < points.size(); ++i)
        out.push_back({points[i], points[(i + 1) % points.size()]});
    return out;
}

} // namespace

TEST_CASE("straight chains: a subdivided polygon has as many sides as it has corners",
          "[maps][boundaries]")
{
    Random random(5);
    const glm::quat turn = random.rotation();
    std::vector<glm::vec3> corners;
    for (const glm::vec3& corner :
         {glm::vec3(0, 0, 0), glm::vec3(0.9f, 0.1f, 0), glm::vec3(0.5f, 0.7f, 0)})
        corners.push_back(turn * corner);
    for (const int parts : {1, 2, 7, 100, 3000}) {
        Segments segments = subdivided(corners, parts);
        random.shuffle(segments);
        CAPTURE(parts);
        const Segments joined = join_straight_chains(segments, 1e-7f);
        // A chain may be cut somewhere between for its length.
        CHECK(joined.size() <= 3u + static_cast<unsigned>(parts) / 500);
        double length = 0;
        for (const BoundarySegment& side : joined)
            length += glm::distance(side.a, side.b);
        CHECK(length ==
              Approx(glm::distance(corners[0], corners[1]) + glm::distance(corners[1], corners[2]) +
                     glm::distance(corners[2], corners[0])));
    }
}

TEST_CASE("straight chains: what bends, branches or turns back stays", "[maps][boundaries]")
{
    const auto count = [](const Segments& segments) {
        return join_straight_chains(segments, 1e-7f).size();
    };
    CHECK(count({}) == 0);
    CHECK(count({flat(0, 0, 1, 0), flat(1, 0, 2, 0)}) == 1);
    CHECK(count({flat(0, 0, 1, 0), flat(1, 0, 2, 1e-4f)}) == 2);
    CHECK(count({flat(0, 0, 1, 0), flat(1, 0, 2, 0), flat(1, 0, 1, 1)}) == 3);
    CHECK(count({flat(0, 0, 1, 0), flat(1, 0, 0.5f, 0)}) == 2); // a spike
    CHECK(count({flat(0, 0, 1, 0), flat(1, 0, 0, 0)}) == 2);
    CHECK(count({flat(0, 0, 0, 0), flat(1, 0, 2, 0)}) == 2);
}

TEST_CASE("straight chains: a curve is not eaten up step by step", "[maps][boundaries]")
{
    std::vector<glm::vec3> circle;
    for (int i = 0; i < 20'000; ++i)
        circle.push_back({std::cos(i * kPiD / 10'000), std::sin(i * kPiD / 10'000), 0});
    const float rounding = 1e-7f;
    for (const BoundarySegment& side : join_straight_chains(subdivided(circle, 1), rounding)) {
        const glm::vec3 middle = (side.a + side.b) * 0.5f;
        CHECK(1 - glm::length(middle) < 20 * rounding);
    }
}
