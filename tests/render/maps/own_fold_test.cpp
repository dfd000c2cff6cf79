#include "render/maps/own_fold.h"
#include "tests/render/maps/flat_walls.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace hipmap;
using namespace hipmap::flat_walls;

namespace {

BoundarySegment raised(BoundarySegment segment, float height_a, float height_b)
{
    segment.a.z = height_a;
    segment.b.z = height_b;
    return segment;
}

/// A closed ring of creases about the z axis.
Segments ring(float radius, float height)
{
    constexpr int kSides = 12;
    const auto corner = [&](int i) {
        const float angle = 2 * float(kPiD) * float(i) / kSides;
        return glm::vec3(radius * std::cos(angle), radius * std::sin(angle), height);
    };
    Segments out;
    for (int i = 0; i < kSides; ++i)
        out.push_back({corner(i), corner(i + 1)});
    return out;
}

PlanePoint plane_point(const glm::vec3& p)
{
    return {{p.x, p.y}, p.z};
}

} // namespace

TEST_CASE("own fold: creases on the far side of a thin sheet hide nothing", "[maps][visible]")
{
    const DiscQuery query = flat_query(0, 0, 1);
    const VisibleDisc disc = look(query, ring(0.1f, -0.2f));
    CHECK(disc.area(1) == Approx(kPiD));
    CHECK(disc.sees({0.5f, 0.2f, 0}));
    CHECK_FALSE(disc.sees({0.05f, 0, -0.2f})); // nor are the photons there gathered
    const VisibleDisc fenced = look(query, ring(0.1f, 0));
    CHECK(fenced.area(1) < 0.04);
    CHECK_FALSE(fenced.sees({0.5f, 0.2f, 0}));
}

TEST_CASE("own fold: only photons that rise less than 45 degrees count near a boundary",
          "[maps][visible]")
{
    const VisibleDisc disc = look(flat_query(0, 0, 1), {line(0.9f, 0, 0, 1)});
    CHECK(disc.sees({0.4f, 0, 0.45f}));
    CHECK(disc.sees({0.4f, 0, -0.45f}));
    CHECK_FALSE(disc.sees({0.4f, 0, 0.47f}));
    CHECK_FALSE(disc.sees({0.4f, 0, -0.47f}));
    CHECK(disc.sees({0, 0, 0.06f})); // within the slack
}

TEST_CASE("own fold: of a crease that rises away, the part on the fold hides", "[maps][visible]")
{
    // Along y at x = 0.3, from the plane at y = 0 to twice as high as it is away.
    const BoundarySegment rising = raised(flat(0.3f, 0, 0.3f, 0.4f), 0, 1);
    const VisibleDisc disc = look(flat_query(0, 0, 1), {rising});
    CHECK_FALSE(disc.sees({0.6f, 0.1f, 0}));
    CHECK(disc.sees({0.6f, 0.7f, 0}));
}

TEST_CASE("own fold: the parts of a segment are those whose points belong to it", "[maps][visible]")
{
    Random random(8);
    const auto anywhere = [&] {
        return glm::vec3(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
    };
    int cut = 0;
    for (int trial = 0; trial < 2000; ++trial) {
        const OwnFold fold(random.between(0.01f, 2));
        const glm::vec3 a = anywhere();
        glm::vec3 b = trial % 2 == 0 ? anywhere() : a + 0.1f * anywhere();
        if (a.z * b.z < 0)
            b.z = -b.z;
        const SegmentParts parts = parts_on_fold(fold, plane_point(a), plane_point(b));
        cut += parts.whole() ? 0 : 1;
        for (int i = 0; i < 50; ++i) {
            const double t = (i + 0.5) / 50;
            const glm::dvec3 p = glm::dvec3(a) + t * (glm::dvec3(b) - glm::dvec3(a));
            const bool kept = std::any_of(parts.begin(), parts.end(), [&](const auto& range) {
                return t >= range.from && t <= range.to;
            });
            CAPTURE(trial, t);
            CHECK(kept == fold.contains({p.x, p.y}, p.z));
        }
    }
    CHECK(cut > 300);
    CHECK(cut < 1700);
}
