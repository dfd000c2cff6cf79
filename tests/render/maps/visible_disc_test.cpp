#include "render/maps/visible_disc.h"
#include "tests/render/maps/flat_walls.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <functional>

using namespace hipmap;
using namespace hipmap::flat_walls;

namespace {

/// Area of the disc beyond a line at distance d from its centre.
double beyond_line(double d, double r)
{
    return d >= r ? 0.0 : r * r * std::acos(d / r) - d * std::sqrt(r * r - d * d);
}

/// Area of the disc beyond two lines at right angles that cross within it.
double beyond_both(double dx, double dy, double r)
{
    const double hx = std::sqrt(r * r - dx * dx);
    const double hy = std::sqrt(r * r - dy * dy);
    return (r * r * (std::acos(dx / r) - std::asin(dy / r)) - dy * (hy - dx) - dx * (hx - dy)) / 2;
}

void check_area(const VisibleDisc& disc, const DiscQuery& query, float r, double expected)
{
    CAPTURE(query.point.x, query.point.y, r);
    const double area = disc.area(r);
    CHECK(area == Approx(expected).epsilon(1e-9));
    CHECK(seen_share(disc, query.point, r) == Approx(area / (kPiD * r * r)).margin(0.012));
}

double side(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool crosses(const glm::dvec2& p, const glm::dvec2& q, const BoundarySegment& s)
{
    const glm::dvec2 a(s.a), b(s.b);
    return side(p, q, a) * side(p, q, b) < 0 && side(a, b, p) * side(a, b, q) < 0;
}

/// The visible area by midpoints of many directions.
double area_by_directions(const glm::dvec2& query, const Segments& segments, double r)
{
    constexpr int kDirections = 20000;
    double sum = 0;
    for (int i = 0; i < kDirections; ++i) {
        const double phi = 2 * kPiD * (i + 0.5) / kDirections;
        const glm::dvec2 end = query + r * glm::dvec2(std::cos(phi), std::sin(phi));
        double share = 1;
        for (const BoundarySegment& s : segments)
            if (crosses(query, end, s)) {
                const double from = side(glm::dvec2(s.a), glm::dvec2(s.b), query);
                const double to = side(glm::dvec2(s.a), glm::dvec2(s.b), end);
                share = std::min(share, from / (from - to));
            }
        sum += share * share;
    }
    return kPiD * r * r * sum / kDirections;
}

/// Corners of a polygon about (x, y), in turn.
Segments polygon(int corners, float x, float y, const std::function<float(int)>& radius_of)
{
    std::vector<glm::vec3> points;
    for (int i = 0; i < corners; ++i) {
        const double phi = 2 * kPiD * (i + 0.25) / corners;
        points.emplace_back(x + radius_of(i) * std::cos(phi), y + radius_of(i) * std::sin(phi), 0);
    }
    Segments out;
    for (int i = 0; i < corners; ++i)
        out.push_back({points[i], points[(i + 1) % corners]});
    return out;
}

double polygon_area(const Segments& sides)
{
    double area = 0;
    for (const BoundarySegment& s : sides)
        area += (double(s.a.x) * s.b.y - double(s.a.y) * s.b.x) / 2;
    return area;
}

/// An L of three unit squares, two faces each, one map: all but x > 1, y > 1.
struct LFloor {
    TriangleMesh mesh;
    Partition partition;

    LFloor()
    {
        for (const glm::vec3& low : {glm::vec3(0, 0, 0), glm::vec3(1, 0, 0), glm::vec3(0, 1, 0)}) {
            const auto first = static_cast<std::uint32_t>(mesh.positions.size());
            for (const glm::vec3& corner : {glm::vec3(0), {1, 0, 0}, {1, 1, 0}, {0, 1, 0}})
                mesh.positions.push_back(low + corner);
            mesh.corners.push_back(glm::uvec3(0, 1, 2) + first);
            mesh.corners.push_back(glm::uvec3(0, 2, 3) + first);
        }
        partition.map_count = 1;
        partition.map_of_face.assign(6, 0);
        for (std::uint32_t edge = 0; edge < 18; ++edge) {
            partition.opposite.push_back(kNone);
            for (std::uint32_t other = 0; other < 18; ++other)
                if (end_of(edge) == end_of(other, 1) && end_of(edge, 1) == end_of(other))
                    partition.opposite.back() = other;
            partition.edge_class.push_back(
                partition.opposite.back() == kNone ? EdgeClass::border : EdgeClass::connected);
        }
    }

    glm::vec3 end_of(std::uint32_t edge, std::uint32_t which = 0) const
    {
        return mesh.positions[mesh.corners[edge / 3][int(edge % 3 + which) % 3]];
    }
};

} // namespace

TEST_CASE("visible disc: without a boundary the whole disc is seen", "[maps][visible]")
{
    const VisibleDisc disc = look(flat_query(0, 0, 1), {});
    CHECK(disc.whole());
    CHECK(disc.area(0.5f) == Approx(kPiD / 4).epsilon(1e-15));
    CHECK(disc.sees({0.3f, 0.4f, 0}));
    const VisibleDisc far = look(flat_query(0, 0, 1), {line(0, 1, 1, 0), flat(2, 0, 3, 0)});
    CHECK(far.area(1) == Approx(kPiD).epsilon(1e-15));
}

TEST_CASE("visible disc: behind one long wall a circular segment is hidden", "[maps][visible]")
{
    for (const float d : {1e-6f, 0.125f, 0.5f, 0.875f, 0.999f}) {
        const DiscQuery query = flat_query(0, 0, 1);
        const VisibleDisc disc = look(query, {line(0, d, 1, 0)});
        for (const float r : {0.0625f, 0.3f, 0.75f, 1.0f})
            check_area(disc, query, r, kPiD * double(r) * r - beyond_line(d, r));
    }
}

TEST_CASE("visible disc: a right-angled corner", "[maps][visible]")
{
    for (const auto& [dx, dy] : {std::pair(0.25f, 0.5f), {0.625f, 0.625f}, {0.0625f, 0.75f}}) {
        const DiscQuery query = flat_query(0, 0, 1);
        const VisibleDisc disc = look(query, {line(dx, 0, 0, 1), line(0, dy, 1, 0)});
        check_area(disc, query, 1,
                   kPiD - beyond_line(dx, 1) - beyond_line(dy, 1) + beyond_both(dx, dy, 1));
    }
}

TEST_CASE("visible disc: a strip between two walls", "[maps][visible]")
{
    const DiscQuery query = flat_query(0, 0, 1);
    const VisibleDisc disc = look(query, {line(0.25f, 0, 0, 1), line(-0.5f, 0, 0, 1)});
    check_area(disc, query, 1, kPiD - beyond_line(0.25, 1) - beyond_line(0.5, 1));
    check_area(disc, query, 0.375f, kPiD * 0.375 * 0.375 - beyond_line(0.25, 0.375));
}

TEST_CASE("visible disc: a slit casts a shadow, once however often it is listed", "[maps][visible]")
{
    const double d = 0.25, h = 0.375;
    const double seen = kPiD - (std::atan(h / d) - d * h);
    const BoundarySegment slit = flat(0.25f, -0.375f, 0.25f, 0.375f);
    const DiscQuery query = flat_query(0, 0, 1);
    check_area(look(query, {slit}), query, 1, seen);
    const BoundarySegment hidden = flat(0.5f, -0.125f, 0.75f, 0.25f);
    check_area(look(query, {slit, {slit.b, slit.a}, hidden, slit}), query, 1, seen);
    CHECK_FALSE(look(query, {slit}).sees({0.75f, 0, 0}));
    CHECK(look(query, {slit}).sees({0.125f, 0, 0}));
}

TEST_CASE("visible disc: round a reflex corner", "[maps][visible]")
{
    // The floor is all but the quadrant x > 0, y > 0; the query is below and right of its corner.
    const double u = 0.25, v = 0.375;
    const double hidden = beyond_line(v, 1) / 2 + (std::atan(u / v) - u * v) / 2;
    const DiscQuery query = flat_query(float(u), float(-v), 1);
    const VisibleDisc disc = look(query, {flat(0, 0, 9, 0), flat(0, 9, 0, 0)});
    check_area(disc, query, 1, kPiD - hidden);
    CHECK(disc.sees({-0.3f, 0.2f, 0}));
    CHECK_FALSE(disc.sees({0.01f, 0.01f, 0}));
}

TEST_CASE("visible disc: a polygon is seen whole, however large the disc", "[maps][visible]")
{
    Random random(5);
    for (const int corners : {3, 4, 7, 20, 2000}) {
        const Segments convex = polygon(corners, 0, 0, [](int) { return 0.5f; });
        Segments shuffled = convex;
        random.shuffle(shuffled);
        for (const float radius : {1.0f, 1e3f, 1e6f}) {
            const DiscQuery query = flat_query(0.1f, 0.05f, radius);
            CHECK(look(query, shuffled).area(radius) == Approx(polygon_area(convex)).epsilon(1e-9));
        }
    }
    // A star is seen whole from its middle.
    const Segments star = polygon(40, 0, 0, [](int i) { return i % 2 ? 0.25f : 0.75f; });
    CHECK(look(flat_query(0, 0, 8), star).area(8) == Approx(polygon_area(star)).epsilon(1e-9));
}

TEST_CASE("visible disc: random walls agree with a search in many directions", "[maps][visible]")
{
    Random random(11);
    for (int trial = 0; trial < 300; ++trial) {
        const int count = 1 + trial % 40;
        const Segments segments = random_segments(random, count);
        const DiscQuery query = flat_query(0, 0, 1);
        const VisibleDisc disc = look(query, segments);
        const float r = random.between(0.05f, 1);
        CAPTURE(trial, count, r);
        const double disc_area = kPiD * r * r;
        CHECK(disc.area(r) ==
              Approx(area_by_directions({0, 0}, segments, r)).margin(2e-3 * disc_area));
        if (trial % 5 == 0)
            CHECK(seen_share(disc, query.point, r) ==
                  Approx(disc.area(r) / disc_area).margin(0.012));
        for (int i = 0; i < 200; ++i) {
            const glm::vec3 photon(random.between(-0.7f, 0.7f), random.between(-0.7f, 0.7f), 0);
            const bool blocked =
                std::any_of(segments.begin(), segments.end(), [&](const BoundarySegment& s) {
                    return crosses({0, 0}, glm::dvec2(photon), s);
                });
            CHECK(disc.sees(photon) == !blocked);
        }
    }
}

TEST_CASE("visible disc: across a fold the boundary is seen along the normal", "[maps][visible]")
{
    // The surface turns up by 0.1 rad at x = 0.25 and ends at arc length 0.5 from the query.
    const float c = std::cos(0.1f), s = std::sin(0.1f);
    const BoundarySegment rim{{0.25f + 0.25f * c, -9, 0.25f * s},
                              {0.25f + 0.25f * c, 9, 0.25f * s}};
    const DiscQuery query = flat_query(0, 0, 1);
    const VisibleDisc disc = look(query, {rim});
    CHECK(disc.area(1) == Approx(kPiD - beyond_line(0.25 + 0.25 * c, 1)).epsilon(1e-7));
    CHECK(disc.sees({0.25f + 0.24f * c, 0.1f, 0.24f * s}));
}

TEST_CASE("visible disc: on an L-shaped floor, what is seen round the corner is what there is",
          "[maps][visible]")
{
    const LFloor floor;
    const MapBoundaries boundaries(floor.mesh, floor.partition);
    REQUIRE(boundaries.of(0).size() == 6);
    Random random(47);
    for (int trial = 0; trial < 200; ++trial) {
        const FaceId face = trial % 6;
        const float u = random.between(0, 1), v = random.between(0, 1 - u);
        DiscQuery query{{}, {}, random.between(0.1f, 2.5f)};
        for (std::uint32_t corner = 0; corner < 3; ++corner)
            query.face[corner] = floor.end_of(3 * face, corner);
        query.point = query.face[0] + u * (query.face[1] - query.face[0]) +
                      v * (query.face[2] - query.face[0]);
        Segments segments;
        boundaries.near(0, query.point, query.radius, segments);
        const VisibleDisc disc = look(query, segments);
        CAPTURE(trial, query.point.x, query.point.y, query.radius);
        for (int i = 0; i < 200; ++i) {
            const float x = random.between(0, 2), y = random.between(0, 2);
            const glm::dvec3 photon(x, y, 0), q(query.point);
            if (glm::distance(photon, q) > query.radius)
                continue;
            // The reflex corner (1, 1) hides what lies beyond the line from the query through it.
            const double turn = side(glm::dvec2(q), glm::dvec2(1, 1), glm::dvec2(photon));
            const bool outside = x > 1 && y > 1;
            const bool hidden =
                outside || (q.x > 1 && y > 1 && turn < 0) || (q.y > 1 && x > 1 && turn > 0);
            CHECK(disc.sees(photon) == !hidden);
        }
        if (trial % 4 == 0)
            CHECK(seen_share(disc, query.point, query.radius) ==
                  Approx(disc.area(query.radius) / (kPiD * query.radius * query.radius))
                      .margin(0.012));
    }
}
