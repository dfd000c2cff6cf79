#include "render/maps/visible_disc.h"
#include "tests/render/maps/flat_walls.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace hipmap;
using namespace hipmap::flat_walls;

namespace {

struct Placement {
    glm::quat rotation{1, 0, 0, 0};
    float scale = 1;
    glm::vec3 offset{0.0f};
    glm::vec3 operator()(const glm::vec3& p) const { return rotation * p * scale + offset; }
    Segments operator()(Segments segments) const
    {
        for (BoundarySegment& s : segments)
            s = {(*this)(s.a), (*this)(s.b)};
        return segments;
    }
    DiscQuery operator()(const DiscQuery& q) const
    {
        return {{(*this)(q.face[0]), (*this)(q.face[1]), (*this)(q.face[2])},
                (*this)(q.point),
                q.radius * scale};
    }
};

} // namespace

TEST_CASE("visible disc: the order and the direction of segments change nothing", "[maps][visible]")
{
    Random random(17);
    for (int trial = 0; trial < 100; ++trial) {
        Segments segments = random_segments(random, 2 + trial % 30);
        const DiscQuery query = flat_query(0, 0, 1);
        const VisibleDisc disc = look(query, segments);
        random.shuffle(segments);
        for (BoundarySegment& s : segments)
            if (random.below(2) == 0)
                std::swap(s.a, s.b);
        const VisibleDisc again = look(query, segments);
        CHECK(again.area(0.8f) == Approx(disc.area(0.8f)).epsilon(1e-12));
        for (int i = 0; i < 100; ++i) {
            const glm::vec3 photon(random.between(-0.7f, 0.7f), random.between(-0.7f, 0.7f), 0);
            CHECK(again.sees(photon) == disc.sees(photon));
        }
    }
}

TEST_CASE("visible disc: place, attitude and size change nothing but rounding", "[maps][visible]")
{
    Random random(23);
    for (int trial = 0; trial < 200; ++trial) {
        const Segments segments = random_segments(random, 1 + trial % 12);
        const DiscQuery query = flat_query(0, 0, 1);
        Placement place;
        place.rotation = random.rotation();
        place.scale = std::pow(10.0f, random.between(-6, 6));
        place.offset = place.scale * glm::vec3(random.between(-2, 2), random.between(-2, 2), 0.7f);
        const VisibleDisc moved = look(place(query), place(segments));
        const double size2 = double(place.scale) * place.scale;
        CAPTURE(trial, place.scale);
        const double area = look(query, segments).area(0.7f);
        CHECK(moved.area(0.7f * place.scale) / size2 == Approx(area).margin(2e-5));
        CHECK(seen_share(moved, place(query.point), 0.7f * place.scale, 60, place.rotation) ==
              Approx(area / (kPiD * 0.49)).margin(0.03));
    }
}

TEST_CASE("visible disc: on an edge, in a corner and beyond by rounding, a query stands inside",
          "[maps][visible]")
{
    Random random(29);
    for (int trial = 0; trial < 500; ++trial) {
        Placement place{random.rotation(), 1.0f, glm::vec3(random.between(-9, 9))};
        const std::array<glm::vec3, 3> face = {place({0, 0, 0}), place({1, 0, 0}),
                                               place({0, 1, 0})};
        const Segments sides = {{face[0], face[1]}, {face[1], face[2]}, {face[2], face[0]}};
        const float t = random.between(0.25f, 0.75f);
        const bool corner = trial % 5 == 0;
        // Some ulps beyond the edge x = 0, or beyond both edges at the corner.
        const float out = -float(trial % 4) * 5e-7f;
        const glm::vec3 point = place(corner ? glm::vec3(out, out, 0) : glm::vec3(out, t, 0));
        const float r = 0.125f;
        const VisibleDisc disc = look({face, point, r}, sides);
        CAPTURE(trial, t, out);
        const double share = disc.area(r) / (kPiD * r * r);
        CHECK(share == Approx(corner ? 0.25 : 0.5).margin(2e-4));
        if (trial % 10 < 2)
            CHECK(seen_share(disc, point, r, 60, place.rotation) == Approx(share).margin(0.02));
        const auto towards = [&](float x, float y) {
            return point + place.rotation * glm::vec3(x, y, 0);
        };
        CHECK(disc.sees(towards(0.07f, 0.06f)));
        CHECK_FALSE(disc.sees(towards(-0.07f, 0.02f)));
        CHECK_FALSE(disc.sees(towards(-0.01f, 0.1f)));
        CHECK(disc.sees(towards(0.05f, -0.05f)) == !corner);
        CHECK_FALSE(disc.sees(towards(-1e-5f, 0)));
    }
}

TEST_CASE("visible disc: a sliver of a face still sees some of itself", "[maps][visible]")
{
    Random random(31);
    for (int trial = 0; trial < 200; ++trial) {
        const Placement place{random.rotation(), 1.0f, glm::vec3(random.between(-1, 1))};
        const float height = std::pow(10.0f, random.between(-6, -1));
        const std::array<glm::vec3, 3> face = {place({0, 0, 0}), place({1, 0, 0}),
                                               place({0.5f, height, 0})};
        const Segments sides = {{face[0], face[1]}, {face[1], face[2]}, {face[2], face[0]}};
        const float u = random.between(0, 1);
        const VisibleDisc disc = look({face, face[0] + u * (face[1] - face[0]), 2.0f}, sides);
        const double area =
            glm::length(glm::cross(glm::dvec3(face[1] - face[0]), glm::dvec3(face[2] - face[0]))) /
            2;
        CAPTURE(trial, height);
        CHECK(disc.area(2.0f) == Approx(area).epsilon(0.02));
        CHECK(disc.area(1e-3f) > 0);
    }
}

TEST_CASE("visible disc: a wall in pieces hides what one wall hides", "[maps][visible]")
{
    Random random(37);
    for (int trial = 0; trial < 100; ++trial) {
        const Placement place{random.rotation(), 1.0f, glm::vec3(random.between(-3, 3))};
        const BoundarySegment wall = flat(-0.75f, 0.25f, 0.5f, 0.3f);
        Segments chain = {wall};
        for (int i = 0; i < 1 + trial % 20; ++i) {
            BoundarySegment& cut = chain[random.below(chain.size())];
            const BoundarySegment rest{cut.a + random.between(0, 1) * (cut.b - cut.a), cut.b};
            cut.b = rest.a;
            chain.push_back(rest);
        }
        chain.push_back({chain[0].a, chain[0].a}); // and a point
        const DiscQuery query = place(flat_query(0, 0, 1));
        const VisibleDisc whole = look(query, place({wall}));
        const VisibleDisc pieces = look(query, place(chain));
        CHECK(pieces.area(1) == Approx(whole.area(1)).epsilon(1e-5));
        // Nothing is seen through the joints.
        for (const BoundarySegment& s : chain)
            for (const float beyond : {1.01f, 1.1f, 1.2f}) {
                const bool inner = s.b.x > wall.a.x + 1e-4f && s.b.x < wall.b.x - 1e-4f;
                CAPTURE(trial, beyond, s.b.x);
                CHECK((!inner || !pieces.sees(query.point + beyond * (place(s.b) - query.point))));
            }
    }
}

TEST_CASE("visible disc: a wall seen end-on hides no area", "[maps][visible]")
{
    const DiscQuery query = flat_query(0, 0, 1);
    CHECK(look(query, {flat(0.25f, 0, 0.75f, 0)}).area(1) == Approx(kPiD).epsilon(1e-12));
    CHECK(look(query, {flat(0.25f, 0, 0.75f, 1e-30f)}).area(1) == Approx(kPiD).epsilon(1e-12));
    CHECK(look(query, {flat(-0.3f, 0.1f, -0.6f, 0.2f)}).area(1) == Approx(kPiD).epsilon(1e-6));
    CHECK(look(query, {flat(0.25f, -1e-30f, 0.75f, 0)}).area(1) == Approx(kPiD).epsilon(1e-12));
    // A corner seen along one of its sides hides what the other side hides.
    const Segments corner = {flat(0.25f, 0, 0.5f, 0), flat(0.5f, 0, 0.5f, 0.5f)};
    const double hidden = (std::atan(1.0) - 0.25) / 2;
    CHECK(look(query, corner).area(1) == Approx(kPiD - hidden).epsilon(1e-12));
}

TEST_CASE("visible disc: walls end-on up to the last bit hide no area", "[maps][visible]")
{
    Random random(43);
    for (int trial = 0; trial < 5000; ++trial) {
        DiscQuery query = flat_query(0.125f, 0.0625f * float(trial % 7), 1);
        query.face[1].y += random.between(0, 1); // so that the plane's coordinates are rounded
        const auto step = [&] { return float(random.below(129)) / 256 - 0.25f; };
        const glm::vec3 direction(step(), step(), 0);
        Segments radial = {{query.point + direction, query.point + 8.0f * direction}};
        const VisibleDisc disc = look(query, radial);
        CAPTURE(trial, direction.x, direction.y);
        CHECK(disc.area(1) == Approx(kPiD).epsilon(1e-12));
        CHECK(disc.area(1) <= kPiD);
        radial.push_back({query.point + direction, query.point + glm::vec3(0.5f, 0.125f, 0)});
        const double expected = look(query, {radial[1]}).area(1);
        CHECK(look(query, radial).area(1) == Approx(expected).epsilon(1e-12));
    }
}

TEST_CASE("visible disc: a face without area sees everything", "[maps][visible]")
{
    const DiscQuery query{{glm::vec3(0), {1, 0, 0}, {2, 0, 0}}, {0.5f, 0, 0}, 1};
    const VisibleDisc disc = look(query, {line(0, 0.1f, 1, 0)});
    CHECK(disc.sees({0.5f, 0.5f, 0}));
    CHECK(disc.area(1) == Approx(kPiD));
}

TEST_CASE("visible disc: one object looks again and again", "[maps][visible]")
{
    Random random(41);
    VisibleDisc reused;
    for (int trial = 0; trial < 60; ++trial) {
        const Segments segments = random_segments(random, trial % 7);
        const DiscQuery query = flat_query(random.between(-0.5f, 0.5f), 0, 1);
        reused.look(query, segments);
        CHECK(reused.area(0.9f) == look(query, segments).area(0.9f));
    }
}
