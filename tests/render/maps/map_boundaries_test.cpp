#include "common/math/random.h"
#include "render/maps/map_boundaries.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

using namespace hipmap;

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// A unit square of two faces with the diagonal from (0, 0) to (1, 1): edge 2 of the first face and
/// edge 0 of the second.  All other edges are borders.
struct Square {
    TriangleMesh mesh;
    Partition partition;

    Square()
    {
        mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
        mesh.corners = {{0, 1, 2}, {0, 2, 3}};
        partition.map_count = 1;
        partition.map_of_face = {0, 0};
        partition.edge_class.assign(6, EdgeClass::border);
        partition.opposite.assign(6, kNone);
        set_diagonal(EdgeClass::connected);
    }

    void set_diagonal(EdgeClass edge_class)
    {
        partition.edge_class[2] = partition.edge_class[3] = edge_class;
        const bool pair =
            edge_class == EdgeClass::connected || edge_class == EdgeClass::unconnected;
        partition.opposite[2] = pair ? 3 : kNone;
        partition.opposite[3] = pair ? 2 : kNone;
    }
};

/// Loose triangles of random size, every edge a border, spread over `map_count` maps.
Square random_triangles(std::uint32_t count, std::uint32_t map_count, std::uint64_t seed)
{
    RandomSequence random(seed, RandomStream::pictures, 0, 0);
    const auto next3 = [&] {
        const glm::vec2 u = random.next2();
        return glm::vec3(u, random.next()) - 0.5f;
    };
    Square out;
    out.mesh = {};
    out.partition = {};
    out.partition.map_count = map_count;
    for (std::uint32_t face = 0; face < count; ++face) {
        const glm::vec3 centre = next3();
        const float size = 1e-3f + std::pow(random.next(), 4.0f);
        for (int corner = 0; corner < 3; ++corner)
            out.mesh.positions.push_back(centre + size * next3());
        out.mesh.corners.push_back(glm::uvec3(0, 1, 2) + 3 * face);
        // The first map gets half of the faces.
        out.partition.map_of_face.push_back(random.next() < 0.5f ? 0 : face % map_count);
    }
    out.partition.edge_class.assign(3 * count, EdgeClass::border);
    out.partition.opposite.assign(3 * count, kNone);
    return out;
}

double distance(const glm::dvec3& point, const BoundarySegment& segment)
{
    const glm::dvec3 a(segment.a), b(segment.b);
    const double t = glm::dot(point - a, b - a) / std::max(glm::dot(b - a, b - a), 1e-300);
    return glm::distance(point, a + std::clamp(t, 0.0, 1.0) * (b - a));
}

std::vector<BoundarySegment> sorted(std::span<const BoundarySegment> segments)
{
    std::vector<BoundarySegment> out(segments.begin(), segments.end());
    const auto key = [](const BoundarySegment& s) {
        return std::tuple(s.a.x, s.a.y, s.a.z, s.b.x, s.b.y, s.b.z);
    };
    std::sort(out.begin(), out.end(), [&](auto& l, auto& r) { return key(l) < key(r); });
    return out;
}

} // namespace

TEST_CASE("map boundaries: a connected edge bounds nothing", "[maps][boundaries]")
{
    const Square square;
    const MapBoundaries boundaries(square.mesh, square.partition);
    const std::vector<BoundarySegment> expected = {{{0, 0, 0}, {1, 0, 0}},
                                                   {{1, 0, 0}, {1, 1, 0}},
                                                   {{1, 1, 0}, {0, 1, 0}},
                                                   {{0, 1, 0}, {0, 0, 0}}};
    CHECK(sorted(boundaries.of(0)) == sorted(expected));
}

TEST_CASE("map boundaries: a crease bounds the maps on both sides", "[maps][boundaries]")
{
    Square square;
    square.set_diagonal(EdgeClass::unconnected);
    square.partition.map_count = 2;
    square.partition.map_of_face = {0, 1};
    const MapBoundaries boundaries(square.mesh, square.partition);
    CHECK(boundaries.of(0).size() == 3);
    CHECK(boundaries.of(1).size() == 3);
}

TEST_CASE("map boundaries: a crease inside one map bounds it once", "[maps][boundaries]")
{
    Square square;
    square.set_diagonal(EdgeClass::unconnected);
    const MapBoundaries boundaries(square.mesh, square.partition);
    REQUIRE(boundaries.of(0).size() == 5);
    const std::vector<BoundarySegment> all = sorted(boundaries.of(0));
    CHECK(std::count(all.begin(), all.end(), BoundarySegment{{1, 1, 0}, {0, 0, 0}}) == 1);
}

TEST_CASE("map boundaries: a non-manifold edge bounds, an edge of a degenerate face does not",
          "[maps][boundaries]")
{
    Square square;
    square.set_diagonal(EdgeClass::non_manifold);
    CHECK(MapBoundaries(square.mesh, square.partition).of(0).size() == 6);

    square.set_diagonal(EdgeClass::degenerate);
    square.partition.map_of_face[1] = kNone;
    const MapBoundaries boundaries(square.mesh, square.partition);
    CHECK(boundaries.of(0).size() == 2); // the face without a map adds none either
}

TEST_CASE("map boundaries: contacts bound, bridged edges do not", "[maps][boundaries]")
{
    Square square;
    square.partition.bridged_edges = {1, 5};
    square.partition.contacts = {{0, {0.5f, 0, 0}, {0.5f, 1, 0}}};
    const std::vector<BoundarySegment> expected = {
        {{0, 0, 0}, {1, 0, 0}}, {{1, 1, 0}, {0, 1, 0}}, {{0.5f, 0, 0}, {0.5f, 1, 0}}};
    const MapBoundaries boundaries(square.mesh, square.partition);
    CHECK(sorted(boundaries.of(0)) == sorted(expected));
}

TEST_CASE("map boundaries: a map without boundary, and no map at all", "[maps][boundaries]")
{
    Square square;
    square.partition.edge_class.assign(6, EdgeClass::connected);
    std::vector<BoundarySegment> found;
    MapBoundaries(square.mesh, square.partition).near(0, {0, 0, 0}, kInfinity, found);
    CHECK(found.empty());
    CHECK_NOTHROW(MapBoundaries(TriangleMesh{}, Partition{}));
}

TEST_CASE("map boundaries: near finds what a loop over all segments finds", "[maps][boundaries]")
{
    const Square scene = random_triangles(2000, 40, 7);
    const MapBoundaries boundaries(scene.mesh, scene.partition);
    RandomSequence random(8, RandomStream::pictures, 0, 0);
    std::size_t total = 0;
    for (MapId map = 0; map < scene.partition.map_count; ++map)
        total += boundaries.of(map).size();
    REQUIRE(total == 6000);
    REQUIRE(boundaries.of(0).size() > 2500);

    for (int query = 0; query < 500; ++query) {
        const MapId map = query % 3 == 0 ? 0 : query % scene.partition.map_count;
        const glm::vec2 u = random.next2();
        const glm::vec3 point = glm::vec3(u, random.next()) - 0.5f;
        const float radius = std::pow(random.next(), 2.0f);
        std::vector<BoundarySegment> expected;
        for (const BoundarySegment& segment : boundaries.of(map))
            if (distance(point, segment) <= radius)
                expected.push_back(segment);
        std::vector<BoundarySegment> found;
        boundaries.near(map, point, radius, found);
        CHECK(found == expected); // and in the order of the map
    }
}

TEST_CASE("map boundaries: near appends, and takes radius zero and infinity", "[maps][boundaries]")
{
    const Square scene = random_triangles(300, 2, 3);
    const MapBoundaries boundaries(scene.mesh, scene.partition);
    const BoundarySegment first = boundaries.of(0)[0];
    std::vector<BoundarySegment> found = {{{9, 9, 9}, {9, 9, 9}}};
    boundaries.near(0, first.a, 0.0f, found);
    CHECK(found.front().a.x == 9);
    CHECK(std::find(found.begin(), found.end(), first) != found.end());
    CHECK(found.size() == 3); // two sides meet in a corner
    found.clear();
    boundaries.near(0, first.a, kInfinity, found);
    CHECK(found.size() == boundaries.of(0).size());
}

TEST_CASE("map boundaries: every segment belongs to a face of its map", "[maps][boundaries]")
{
    const Square scene = random_triangles(500, 5, 21);
    const MapBoundaries boundaries(scene.mesh, scene.partition);
    for (MapId map = 0; map < 5; ++map) {
        std::vector<BoundarySegment> expected;
        for (FaceId face = 0; face < 500; ++face) {
            if (scene.partition.map_of_face[face] != map)
                continue;
            const glm::vec3* p = &scene.mesh.positions[3 * face];
            expected.insert(expected.end(), {{p[0], p[1]}, {p[1], p[2]}, {p[2], p[0]}});
        }
        CHECK(sorted(boundaries.of(map)) == sorted(expected));
    }
}
