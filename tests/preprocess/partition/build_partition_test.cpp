#include "common/partition/check_partition.h"
#include "preprocess/partition/build_partition.h"
#include "tests/support/tiny_meshes.h"

#include <catch2/catch.hpp>
#include <tbb/global_control.h>

using namespace hipmap;

namespace {

bool same(const Partition& a, const Partition& b)
{
    return a.scene == b.scene && a.map_count == b.map_count && a.map_of_face == b.map_of_face &&
           a.edge_class == b.edge_class && a.opposite == b.opposite && a.flipped == b.flipped &&
           a.closed == b.closed && a.reach == b.reach && a.candidate == b.candidate &&
           a.kept_edges == b.kept_edges && a.self_distance == b.self_distance &&
           a.bridged_edges == b.bridged_edges && a.contacts == b.contacts;
}

} // namespace

TEST_CASE("build_partition: a cube is six maps of two candidates each", "[partition]")
{
    const PartitionResult result = build_partition(tiny::make_scene(tiny::cube()), {});
    const PartitionSummary& summary = result.summary;
    CHECK(defect_of(result.partition) == "");
    CHECK(result.partition.map_count == 6);
    CHECK(summary.welded_vertices == 8);
    CHECK(summary.edges == std::array<std::size_t, 5>{6, 12, 0, 0, 0});
    CHECK(summary.candidates == 12);
    CHECK(summary.closed_faces == 12);
    REQUIRE(summary.maps.size() == 6);
    for (const PartitionSummary::Map& map : summary.maps) {
        CHECK(map.faces == 2);
        CHECK(map.area == Approx(1));
    }
}

TEST_CASE("build_partition: a smooth sphere is one map", "[partition]")
{
    const PartitionResult result = build_partition(tiny::make_scene(tiny::uv_sphere(32, 16)), {});
    CHECK(result.partition.map_count == 1);
    CHECK(result.summary.edges[0] == result.summary.faces * 3 / 2);
}

TEST_CASE("build_partition: whatever the mesh, the partition is sound", "[partition]")
{
    for (std::uint64_t seed = 0; seed < 1000; ++seed) {
        const Scene scene = tiny::make_scene(tiny::random_mesh(seed, 4 + seed % 30, 1 + seed % 50));
        const PartitionResult result = build_partition(scene, {.angle_threshold = 1.0});
        INFO("seed " << seed);
        REQUIRE(defect_of(result.partition) == "");
        REQUIRE(result.partition.face_count() == scene.mesh.face_count());
    }
}

TEST_CASE("build_partition: the same with one and with four threads", "[partition]")
{
    const Scene scene = tiny::make_scene(tiny::together(tiny::uv_sphere(60, 40), tiny::cube()));
    const auto run = [&](std::size_t threads) {
        const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
        return build_partition(scene, {}).partition;
    };
    CHECK(same(run(1), run(4)));
}

TEST_CASE("build_partition: a crack narrower than the weld distance is closed", "[partition]")
{
    TriangleMesh right = tiny::quad();
    for (glm::vec3& p : right.positions)
        p += glm::vec3(1.001f, 0.0005f, 0);
    const Scene scene = tiny::make_scene(tiny::together(tiny::quad(), right));
    CHECK(build_partition(scene, {}).partition.map_count == 2);
    CHECK(build_partition(scene, {.weld_distance = 1e-3}).partition.map_count == 2);
    const PartitionResult welded = build_partition(scene, {.weld_distance = 2e-3});
    CHECK(welded.partition.map_count == 1);
    CHECK(welded.summary.welded_vertices == 6);
}
