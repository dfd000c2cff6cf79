#include "preprocess/partition/connected_edges.h"
#include "preprocess/partition/share_maps.h"
#include "tests/support/tiny_meshes.h"

#include <catch2/catch.hpp>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <numbers>

using namespace hipmap;

namespace {

constexpr double kDegree = std::numbers::pi / 180;

EdgeClasses classes_of(const TriangleMesh& mesh, double degrees)
{
    const HalfEdges edges = find_half_edges(mesh, weld_vertices(mesh.positions));
    return classify_edges(mesh, edges, degrees * kDegree);
}

std::uint32_t maps_of(const TriangleMesh& mesh, double degrees)
{
    const HalfEdges edges = find_half_edges(mesh, weld_vertices(mesh.positions));
    const EdgeClasses classes = classify_edges(mesh, edges, degrees * kDegree);
    return share_maps(classes.edge_class, edges.opposite).count;
}

glm::quat random_rotation(std::uint64_t seed)
{
    RandomSequence random(seed, RandomStream::pictures, 0, 0);
    glm::vec4 q;
    do {
        for (int i = 0; i < 4; ++i)
            q[i] = 2 * random.next() - 1;
    } while (glm::dot(q, q) > 1 || glm::dot(q, q) < 0.01f);
    q = glm::normalize(q);
    return {q.x, q.y, q.z, q.w};
}

/// Two faces whose fronts differ by an angle, joined at an edge on the x axis.
TriangleMesh hinge(double degrees)
{
    const auto c = static_cast<float>(std::cos(degrees * kDegree));
    const auto s = static_cast<float>(std::sin(degrees * kDegree));
    return tiny::make_mesh({{0, 0, 0}, {1, 0, 0}, {0.4f, -1, 0}, {0.7f, c, s}},
                           {{1, 0, 2}, {0, 1, 3}});
}

} // namespace

TEST_CASE("classify_edges: a cube at 90 degrees has six maps however it is turned", "[partition]")
{
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
        TriangleMesh cube = tiny::cube();
        const glm::quat rotation = random_rotation(seed);
        for (glm::vec3& p : cube.positions)
            p = rotation * p;
        REQUIRE(maps_of(cube, 90) == 6);
        REQUIRE(maps_of(cube, 91) == 1);
        REQUIRE(maps_of(cube, 30) == 6);
    }
}

TEST_CASE("classify_edges: edges at the threshold are counted", "[partition]")
{
    CHECK(classes_of(tiny::cube(), 90).edges_in_band == 12);
    CHECK(classes_of(tiny::cube(), 91).edges_in_band == 0);
    CHECK(classes_of(tiny::cube(), 89).edges_in_band == 0);
}

TEST_CASE("classify_edges: a hinge is connected below the threshold only", "[partition]")
{
    for (double angle = 1; angle < 180; angle += 7.3) {
        CHECK(classes_of(hinge(angle), angle + 0.1).edge_class[0] == EdgeClass::connected);
        CHECK(classes_of(hinge(angle), angle - 0.1).edge_class[0] == EdgeClass::unconnected);
        CHECK(classes_of(hinge(angle), angle).edge_class[0] == EdgeClass::unconnected);
        CHECK(classes_of(hinge(angle), angle).edges_in_band == 1);
    }
}

TEST_CASE("classify_edges: at 0 degrees nothing is connected, at 180 all that is not folded back",
          "[partition]")
{
    CHECK(maps_of(tiny::quad(), 0) == 2);
    CHECK(maps_of(tiny::uv_sphere(8, 6), 0) == tiny::uv_sphere(8, 6).face_count());
    CHECK(maps_of(tiny::tetrahedron(), 180) == 1);
    CHECK(maps_of(hinge(180), 180) == 2);
}

TEST_CASE("classify_edges: a face wound the other way stays in its map", "[partition]")
{
    CHECK(maps_of(tiny::flipped_pair(), 30) == 1);
}

TEST_CASE("classify_edges: neither size nor place changes an angle", "[partition]")
{
    for (const float size : {1e-18f, 1e-6f, 1.0f, 1e6f}) {
        TriangleMesh cube = tiny::cube();
        for (glm::vec3& p : cube.positions)
            p *= size;
        CHECK(maps_of(cube, 30) == 6);
        CHECK(maps_of(cube, 91) == 1);
    }
}

TEST_CASE("classify_edges: both halves of an edge agree", "[partition]")
{
    for (std::uint64_t seed = 0; seed < 500; ++seed) {
        const TriangleMesh mesh = tiny::random_mesh(seed, 5 + seed % 20, 2 + seed % 30);
        const HalfEdges edges = find_half_edges(mesh, weld_vertices(mesh.positions));
        const EdgeClasses classes = classify_edges(mesh, edges, 90 * kDegree);
        for (std::size_t edge = 0; edge < classes.edge_class.size(); ++edge)
            if (edges.opposite[edge] != kNone)
                REQUIRE(classes.edge_class[edge] == classes.edge_class[edges.opposite[edge]]);
            else
                REQUIRE(classes.edge_class[edge] == edges.edge_class[edge]);
    }
}

namespace {

std::uint32_t maps_split_by(const TriangleMesh& mesh, double degrees, SplitBy by)
{
    const HalfEdges edges = find_half_edges(mesh, weld_vertices(mesh.positions));
    return share_maps(classify_edges(mesh, edges, degrees * kDegree, by).edge_class, edges.opposite)
        .count;
}

/// Normals across each face, on vertices that no other side has.
void shade_flat(TriangleMesh& mesh)
{
    for (FaceId face = 0; face < mesh.face_count(); ++face)
        for (int c = 0; c < 3; ++c)
            mesh.normals[mesh.corners[face][c]] =
                glm::vec3(glm::normalize(scaled_normal(mesh, face)));
}

/// Normals away from the origin, as a smooth surface has them.
void shade_smooth(TriangleMesh& mesh)
{
    for (std::size_t v = 0; v < mesh.positions.size(); ++v)
        mesh.normals[v] = glm::normalize(mesh.positions[v]);
}

} // namespace

TEST_CASE("classify_edges: by normals, a smooth cube is one map and a flat one six", "[partition]")
{
    TriangleMesh cube = tiny::cube();
    shade_smooth(cube);
    CHECK(maps_split_by(cube, 30, SplitBy::normals) == 1);
    CHECK(maps_split_by(cube, 30, SplitBy::both) == 6);
    shade_flat(cube);
    for (const double degrees : {0.0, 30.0, 170.0})
        CHECK(maps_split_by(cube, degrees, SplitBy::normals) == 6);
    CHECK(maps_split_by(cube, 170, SplitBy::both) == 6);
    CHECK(maps_split_by(cube, 170, SplitBy::angle) == 1);
}

TEST_CASE("classify_edges: by normals, a ring of hard edges parts a sphere", "[partition]")
{
    TriangleMesh sphere = tiny::split_all(tiny::uv_sphere(32, 16));
    shade_smooth(sphere);
    CHECK(maps_split_by(sphere, 30, SplitBy::both) == 1);
    for (FaceId face = 0; face < sphere.face_count(); ++face) {
        const glm::uvec3& c = sphere.corners[face];
        const float middle =
            sphere.positions[c.x].y + sphere.positions[c.y].y + sphere.positions[c.z].y;
        for (int i = 0; i < 3 && middle > 0; ++i)
            if (std::abs(sphere.positions[c[i]].y) < 1e-6f)
                sphere.normals[c[i]] = {0, 1, 0};
    }
    CHECK(maps_split_by(sphere, 30, SplitBy::normals) == 2);
    CHECK(maps_split_by(sphere, 30, SplitBy::both) == 2);
    CHECK(maps_split_by(sphere, 30, SplitBy::angle) == 1);
}

TEST_CASE("classify_edges: without normals the angle decides", "[partition]")
{
    for (const SplitBy by : {SplitBy::normals, SplitBy::both}) {
        CHECK(maps_split_by(tiny::cube(), 30, by) == 6);
        CHECK(maps_split_by(tiny::cube(), 91, by) == 1);
    }
}
