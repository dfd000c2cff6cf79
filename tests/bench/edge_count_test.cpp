#include "bench/edge_count.h"
#include "tests/support/tiny_meshes.h"

#include <catch2/catch.hpp>

using namespace hipmap;

namespace {

void check_count(const TriangleMesh& mesh, std::size_t border, std::size_t pairs,
                 std::size_t several)
{
    const EdgeCount count = count_edges(mesh, false)[0];
    CHECK(count.border == border);
    CHECK(count.pairs == pairs);
    CHECK(count.several == several);
}

} // namespace

TEST_CASE("count_edges: by the faces of an edge, vertices at one position taken as one",
          "[partition]")
{
    check_count(tiny::cube(), 0, 18, 0);
    check_count(tiny::open_box(), 4, 13, 0);
    check_count(tiny::quad(), 4, 1, 0);
    check_count(tiny::fin(), 6, 0, 1);
    check_count(tiny::doubled(), 0, 3, 0);
    check_count(tiny::bow_tie(), 6, 0, 0);
    check_count(tiny::split_all(tiny::uv_sphere(8, 6)), 0,
                tiny::uv_sphere(8, 6).face_count() * 3 / 2, 0);
    check_count(tiny::together(tiny::cube(), tiny::cube()), 0, 0, 18);
    check_count(tiny::make_mesh({}, {}), 0, 0, 0);
}

TEST_CASE("count_edges: objects are counted by themselves", "[partition]")
{
    TriangleMesh mesh = tiny::together(tiny::cube(), tiny::together(tiny::cube(), tiny::quad()));
    mesh.object_names = {"one", "another", "sheet", "nothing"};
    for (FaceId face = 0; face < mesh.face_count(); ++face)
        mesh.object_of_face[face] = face / 12;
    const std::vector<EdgeCount> counts = count_edges(mesh, true);
    REQUIRE(counts.size() == 4);
    CHECK(counts[0].closed_manifold());
    CHECK(counts[1].closed_manifold());
    CHECK(!counts[2].closed_manifold());
    CHECK(counts[2].border == 4);
    CHECK(!counts[3].closed_manifold());
    CHECK(!count_edges(mesh, false)[0].closed_manifold());
}
