#include "preprocess/mesh/half_edges.h"
#include "preprocess/mesh/openmesh_pairs.h"
#include "preprocess/mesh/welded_faces.h"
#include "tests/support/tiny_meshes.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <map>

using namespace hipmap;

namespace {

HalfEdges half_edges(const TriangleMesh& mesh)
{
    return find_half_edges(mesh, weld_vertices(mesh.positions));
}

std::size_t count_class(const HalfEdges& edges, EdgeClass edge_class)
{
    return static_cast<std::size_t>(std::ranges::count(edges.edge_class, edge_class));
}

bool all_closed(const HalfEdges& edges)
{
    return std::ranges::count(edges.closed, 1) == std::ssize(edges.closed);
}

bool any_closed(const HalfEdges& edges)
{
    return std::ranges::count(edges.closed, 1) > 0;
}

/// What must hold of every mesh: an array entry for each face, opposites that point back across the
/// same two positions and wound alike, classes that agree with them.
void require_sound(const TriangleMesh& mesh, const HalfEdges& edges)
{
    REQUIRE(edges.opposite.size() == 3 * mesh.face_count());
    REQUIRE(edges.edge_class.size() == 3 * mesh.face_count());
    REQUIRE(edges.flipped.size() == mesh.face_count());
    REQUIRE(edges.closed.size() == mesh.face_count());
    const auto corner = [&](std::uint32_t face, std::uint32_t c) {
        return mesh.positions[mesh.corners[face][static_cast<int>(c % 3)]];
    };
    const auto start = [&](std::uint32_t edge) {
        return corner(edge / 3, edge % 3 + edges.flipped[edge / 3]);
    };
    const auto end = [&](std::uint32_t edge) {
        return corner(edge / 3, edge % 3 + 1 - edges.flipped[edge / 3]);
    };
    for (std::uint32_t edge = 0; edge < edges.opposite.size(); ++edge) {
        const std::uint32_t twin = edges.opposite[edge];
        REQUIRE((edges.edge_class[edge] == EdgeClass::unconnected) == (twin != kNone));
        if (twin == kNone)
            continue;
        REQUIRE(edges.opposite[twin] == edge);
        REQUIRE(twin / 3 != edge / 3);
        REQUIRE(start(edge) == end(twin));
        REQUIRE(end(edge) == start(twin));
    }
}

} // namespace

TEST_CASE("half edges: the faces of a quad meet at its diagonal", "[mesh]")
{
    const HalfEdges edges = half_edges(tiny::split_all(tiny::quad()));
    CHECK(edges.opposite == std::vector<std::uint32_t>{kNone, kNone, 3, 2, kNone, kNone});
    CHECK(edges.defects.border_edges == 4);
    CHECK(count_class(edges, EdgeClass::border) == 4);
    CHECK_FALSE(any_closed(edges));
}

TEST_CASE("half edges: a tetrahedron, a cube and a sphere are closed", "[mesh]")
{
    for (const TriangleMesh& mesh :
         {tiny::tetrahedron(), tiny::cube(), tiny::uv_sphere(16, 8), tiny::uv_sphere(3, 2)}) {
        const HalfEdges edges = half_edges(mesh);
        require_sound(mesh, edges);
        CHECK(count_class(edges, EdgeClass::unconnected) == 3 * mesh.face_count());
        CHECK(all_closed(edges));
    }
}

TEST_CASE("half edges: an open box is not closed", "[mesh]")
{
    const TriangleMesh mesh = tiny::open_box();
    REQUIRE(mesh.face_count() == 10);
    const HalfEdges edges = half_edges(mesh);
    CHECK(edges.defects.border_edges == 4);
    CHECK_FALSE(any_closed(edges));
}

TEST_CASE("half edges: a sheet with two coincident sides is not closed", "[mesh]")
{
    TriangleMesh back = tiny::fan(6);
    for (FaceId face = 0; face < back.face_count(); ++face)
        tiny::flip(back, face);
    // The rim joins both sides; their inner edges have four faces each.
    CHECK_FALSE(any_closed(half_edges(tiny::together(tiny::fan(6), back))));
    // Two sides with centres of their own share the rim only: no border, and no volume.
    back.positions[0] = {0.25f, 0, 0};
    const HalfEdges edges = half_edges(tiny::together(tiny::fan(6), back));
    CHECK(edges.defects.border_edges == 0);
    CHECK_FALSE(any_closed(edges));
}

TEST_CASE("half edges: closed is told for each surface by itself", "[mesh]")
{
    TriangleMesh sheet = tiny::quad();
    for (glm::vec3& p : sheet.positions)
        p.z = 2;
    const TriangleMesh mesh = tiny::together(tiny::tetrahedron(), sheet);
    CHECK(half_edges(mesh).closed == std::vector<std::uint8_t>{1, 1, 1, 1, 0, 0});
}

TEST_CASE("half edges: two boxes that share an edge are closed if they are two objects", "[mesh]")
{
    TriangleMesh other = tiny::cube();
    for (glm::vec3& p : other.positions)
        p += glm::vec3(1, 1, 0);
    TriangleMesh both = tiny::together(tiny::cube(), other);
    CHECK_FALSE(any_closed(half_edges(both)));
    std::fill(both.object_of_face.begin() + 12, both.object_of_face.end(), 1);
    const HalfEdges edges = half_edges(both);
    CHECK(edges.defects.non_manifold_edges == 1);
    CHECK(all_closed(edges));
}

TEST_CASE("half edges: pinholes far below a pixel do not open a surface", "[mesh]")
{
    // The tip of a tetrahedron is cut off: its border is about 4.2 times as long as the cut.
    const auto blunt = [](float cut) {
        return tiny::make_mesh(
            {{0, 0, 0},
             {1, 0, 0},
             {0, 1, 0},
             {0, 0, 1 - cut},
             {cut, 0, 1 - cut},
             {0, cut, 1 - cut}},
            {{0, 2, 1}, {0, 1, 4}, {0, 4, 3}, {0, 3, 5}, {0, 5, 2}, {1, 2, 5}, {1, 5, 4}});
    };
    CHECK_FALSE(any_closed(half_edges(blunt(0.1f))));
    CHECK_FALSE(any_closed(half_edges(blunt(1e-3f))));
    CHECK(all_closed(half_edges(blunt(1e-4f))));
}

TEST_CASE("half edges: a sliver without area does not open a closed surface", "[mesh]")
{
    // The edge from 0 to 1 of a tetrahedron is split by vertex 4 in one of its faces only, and the
    // gap is filled with a face without area.
    TriangleMesh mesh = tiny::tetrahedron();
    mesh.positions.emplace_back(0.5f, 0, 0);
    mesh.corners = {{0, 2, 4}, {4, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}, {0, 4, 1}};
    mesh = tiny::make_mesh(mesh.positions, mesh.corners);
    const HalfEdges edges = half_edges(mesh);
    require_sound(mesh, edges);
    CHECK(edges.closed == std::vector<std::uint8_t>{1, 1, 1, 1, 1, 0});
}

TEST_CASE("half edges: two cones that touch at their tips are two closed surfaces", "[mesh]")
{
    TriangleMesh other = tiny::tetrahedron();
    for (glm::vec3& p : other.positions)
        p = {-p.x, -p.y, p.z * 0.5f}; // a rotation about z, and flatter; both share the origin
    const TriangleMesh both = tiny::together(tiny::tetrahedron(), other);
    HalfEdges edges = half_edges(both);
    // They share the tip and the lower part of the z axis only as points, not as an edge.
    require_sound(both, edges);
    CHECK(edges.defects.refused_faces == 0);
    CHECK(all_closed(edges));
}

TEST_CASE("half edges: all faces of a fin keep their place, its edge joins none", "[mesh]")
{
    const TriangleMesh mesh = tiny::fin();
    const HalfEdges edges = half_edges(mesh);
    require_sound(mesh, edges);
    CHECK(edges.defects.non_manifold_edges == 1);
    CHECK(count_class(edges, EdgeClass::non_manifold) == 3);
    CHECK(count_class(edges, EdgeClass::border) == 6);
}

TEST_CASE("half edges: where three walls meet each wall stays whole", "[mesh]")
{
    // Three quads on the edge (0,0,0)-(0,0,1).
    TriangleMesh mesh;
    for (int i = 0; i < 3; ++i) {
        const float angle = 2 * static_cast<float>(i);
        const glm::vec3 side(std::cos(angle), std::sin(angle), 0);
        const glm::vec3 up(0, 0, 1);
        const TriangleMesh wall =
            tiny::make_mesh({{0, 0, 0}, side, side + up, up}, {{0, 1, 2}, {0, 2, 3}});
        mesh = i == 0 ? wall : tiny::together(mesh, wall);
    }
    const HalfEdges edges = half_edges(mesh);
    require_sound(mesh, edges);
    CHECK(count_class(edges, EdgeClass::non_manifold) == 3);
    CHECK(count_class(edges, EdgeClass::unconnected) == 6);
    CHECK(edges.defects.refused_faces == 0);
}

TEST_CASE("half edges: a bow-tie is two faces with borders", "[mesh]")
{
    const HalfEdges edges = half_edges(tiny::bow_tie());
    CHECK(count_class(edges, EdgeClass::border) == 6);
    CHECK(edges.defects.refused_faces == 0);
}

TEST_CASE("half edges: a face twice is no closed surface", "[mesh]")
{
    const HalfEdges edges = half_edges(tiny::doubled());
    require_sound(tiny::doubled(), edges);
    CHECK_FALSE(any_closed(edges));
}

TEST_CASE("half edges: a neighbour wound the other way is marked and paired", "[mesh]")
{
    const TriangleMesh mesh = tiny::flipped_pair();
    const HalfEdges edges = half_edges(mesh);
    require_sound(mesh, edges);
    CHECK(edges.flipped == std::vector<std::uint8_t>{0, 1});
    CHECK(count_class(edges, EdgeClass::unconnected) == 2);
}

TEST_CASE("half edges: the smaller area is turned, a whole surface never", "[mesh]")
{
    TriangleMesh sphere = tiny::uv_sphere(12, 6);
    for (const FaceId face : {0u, 7u, 31u})
        tiny::flip(sphere, face);
    HalfEdges edges = half_edges(sphere);
    require_sound(sphere, edges);
    for (FaceId face = 0; face < sphere.face_count(); ++face)
        REQUIRE(edges.flipped[face] == (face == 0 || face == 7 || face == 31));
    CHECK(all_closed(edges));

    TriangleMesh inward = tiny::uv_sphere(12, 6);
    for (FaceId face = 0; face < inward.face_count(); ++face)
        tiny::flip(inward, face);
    CHECK(half_edges(inward).defects.flipped_faces == 0);
}

TEST_CASE("half edges: a Moebius strip is cut across once", "[mesh]")
{
    const TriangleMesh mesh = tiny::moebius(12);
    const HalfEdges edges = half_edges(mesh);
    require_sound(mesh, edges);
    CHECK(edges.defects.cut_edges == 1);
    CHECK(count_class(edges, EdgeClass::non_manifold) == 2);
    CHECK(count_class(edges, EdgeClass::border) == 24);
    CHECK(edges.defects.flipped_faces == 0);
    CHECK_FALSE(any_closed(edges));
}

TEST_CASE("half edges: degenerate faces keep their place without neighbours", "[mesh]")
{
    const TriangleMesh mesh = tiny::degenerate();
    const HalfEdges edges = half_edges(mesh);
    require_sound(mesh, edges);
    CHECK(edges.defects.degenerate_faces == 2);
    for (std::size_t edge = 3; edge < 9; ++edge)
        CHECK(edges.edge_class[edge] == EdgeClass::degenerate);
    CHECK(edges.opposite[2] == 9); // across the diagonal, past the flat faces
}

TEST_CASE("half edges: any soup of triangles is sound, its pairs those of a plain count", "[mesh]")
{
    std::size_t refused = 0;
    for (std::uint64_t seed = 0; seed < 2000; ++seed) {
        const TriangleMesh mesh = tiny::random_mesh(seed, 4 + seed % 20, 1 + seed % 40);
        const HalfEdges edges = half_edges(mesh);
        require_sound(mesh, edges);
        refused += edges.defects.refused_faces;

        const VertexWeld weld = weld_vertices(mesh.positions);
        std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
        const auto ends = [&](std::uint32_t edge) {
            const auto vertex = [&](std::uint32_t corner) {
                return weld.id_of_vertex[mesh.corners[edge / 3][static_cast<int>(corner % 3)]];
            };
            return std::minmax({vertex(edge % 3), vertex(edge % 3 + 1)});
        };
        for (std::uint32_t edge = 0; edge < 3 * mesh.face_count(); ++edge)
            if (edges.edge_class[edge] != EdgeClass::degenerate)
                ++uses[ends(edge)];
        for (std::uint32_t edge = 0; edge < 3 * mesh.face_count(); ++edge) {
            if (edges.edge_class[edge] == EdgeClass::degenerate)
                continue;
            REQUIRE((uses[ends(edge)] == 1) == (edges.edge_class[edge] == EdgeClass::border));
            if (uses[ends(edge)] > 2)
                REQUIRE(edges.edge_class[edge] == EdgeClass::non_manifold);
        }
    }
    CHECK(refused == 0);
}

TEST_CASE("half edges: on a manifold OpenMesh would find the same", "[mesh]")
{
    for (const TriangleMesh& mesh : {tiny::cube(), tiny::open_box(), tiny::uv_sphere(30, 20),
                                     tiny::together(tiny::uv_sphere(9, 7), tiny::cube())}) {
        const VertexWeld weld = weld_vertices(mesh.positions);
        const WeldedFaces faces = weld_faces(mesh, weld);
        std::vector<WoundFace> wound;
        for (FaceId face = 0; face < mesh.face_count(); ++face) {
            const std::uint32_t* v = &faces.vertex_of_corner[std::size_t{3} * face];
            if (!faces.degenerate[face])
                wound.push_back({face, {v[0], v[1], v[2]}, false});
        }
        const HalfEdgePairs pairs = pair_half_edges(wound, weld.count, mesh.face_count());
        REQUIRE(pairs.refused_faces == 0);
        CHECK(half_edges(mesh).opposite == pairs.opposite);
    }
}

TEST_CASE("pair_half_edges: a face that OpenMesh refuses is entered with new vertices", "[mesh]")
{
    const std::vector<WoundFace> fin{
        {0, {0, 1, 2}, false}, {1, {1, 0, 3}, false}, {2, {0, 1, 4}, false}, {4, {1, 2, 5}, true}};
    const HalfEdgePairs pairs = pair_half_edges(fin, 6, 5);
    CHECK(pairs.refused_faces == 1);
    std::vector<std::uint32_t> expected(15, kNone);
    expected[0] = 3; // the first two faces
    expected[3] = 0;
    expected[1] = 12; // past the third, and a turned one
    expected[12] = 1;
    CHECK(pairs.opposite == expected);
}
