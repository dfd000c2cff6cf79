#include "bench/brute_force_partition.h"
#include "common/scene/load_scene.h"
#include "preprocess/partition/build_partition.h"
#include "tests/support/hard_surfaces.h"

#include <catch2/catch.hpp>

#include <filesystem>

using namespace hipmap;

namespace {

Partition partition_of(const TriangleMesh& mesh, double angle_threshold = 0.5)
{
    return build_partition(tiny::make_scene(mesh), {.angle_threshold = angle_threshold}).partition;
}

/// Lattices, where faces coincide, stand on and cut through each other, the same out of place, and
/// surfaces with one side; of every winding.
TriangleMesh random_triangles(std::uint64_t seed)
{
    const auto size = static_cast<std::uint32_t>(seed % 60);
    TriangleMesh mesh = tiny::random_mesh(seed, 5 + size, 2 + 2 * size);
    if (seed % 5 == 0)
        mesh = tiny::moebius(3 + size);
    for (FaceId face = 0; face < mesh.face_count(); ++face)
        if (mix_bits(seed + face) % 2)
            tiny::flip(mesh, face);
    if (seed % 3 == 0)
        tiny::jitter(mesh, 0.01f, seed);
    if (seed % 2 == 0)
        tiny::transform(mesh, tiny::random_rotation(seed));
    return mesh;
}

} // namespace

TEST_CASE("brute force: the partitions of random triangles are equal to its own", "[partition]")
{
    std::size_t joined = 0, cut = 0;
    for (std::uint64_t seed = 0; seed < 1000; ++seed) {
        INFO("seed " << seed);
        const TriangleMesh mesh = random_triangles(seed);
        const double angle = 0.1 * static_cast<double>(seed % 32);
        const PartitionResult result =
            build_partition(tiny::make_scene(mesh), {.angle_threshold = angle});
        REQUIRE(difference_from_brute_force(mesh, result.partition) == "");
        joined += result.summary.joined_maps;
        cut += result.summary.defects.cut_edges;
    }
    CHECK(joined > 100);
    CHECK(cut > 100);
    WARN("1000 cases, " << joined << " maps joined at seams, " << cut << " edges cut");
}

TEST_CASE("brute force: the partitions of surfaces are equal to its own", "[partition]")
{
    const std::vector<TriangleMesh> meshes{tiny::cube(),
                                           tiny::open_box(),
                                           tiny::quad(),
                                           tiny::fan(100),
                                           tiny::fin(),
                                           tiny::tetrahedron(),
                                           tiny::bow_tie(),
                                           tiny::degenerate(),
                                           tiny::flipped_pair(),
                                           tiny::doubled(),
                                           tiny::moebius(20),
                                           tiny::uv_sphere(32, 16),
                                           tiny::hairpin(4, 1e-3f),
                                           tiny::thin_shell(16, 1e-4f),
                                           tiny::slit_floor(4, 0.01f),
                                           tiny::t_junction_floor(4),
                                           tiny::notched_fan(20, 3)};
    for (std::size_t i = 0; i < meshes.size(); ++i)
        for (std::uint64_t seed = 0; seed < 4; ++seed) {
            INFO("mesh " << i << ", pose " << seed);
            TriangleMesh mesh = tiny::together(meshes[i], meshes[(i + seed) % meshes.size()]);
            tiny::transform(mesh, tiny::random_rotation(seed));
            REQUIRE(difference_from_brute_force(mesh, partition_of(mesh)) == "");
        }
}

TEST_CASE("brute force: the partitions of the smaller bundled scenes are equal to its own",
          "[partition]")
{
    const std::filesystem::path assets = std::filesystem::path(HIPMAP_SOURCE_DIR) / "assets";
    std::size_t compared = 0;
    for (const auto& entry : std::filesystem::directory_iterator(assets)) {
        if (entry.path().extension() != ".glb")
            continue;
        INFO(entry.path().string());
        const Scene scene = load_scene(entry.path(), {}).scene;
        constexpr std::size_t kMostFaces = 10'000; // it is quadratic
        if (scene.mesh.face_count() > kMostFaces)
            continue;
        CHECK(difference_from_brute_force(scene.mesh, build_partition(scene, {}).partition) == "");
        ++compared;
    }
    CHECK(compared > 0);
}

TEST_CASE("brute force: an error in a class, an opposite, a winding or a map is found",
          "[partition]")
{
    const TriangleMesh mesh =
        tiny::together(tiny::cube(), tiny::together(tiny::moebius(20), tiny::t_junction_floor(2)));
    const Partition right = partition_of(mesh);
    REQUIRE(difference_from_brute_force(mesh, right) == "");
    const auto differs = [&](const auto& spoil) {
        Partition wrong = right;
        spoil(wrong);
        return difference_from_brute_force(mesh, wrong) != "";
    };
    for (std::uint32_t edge = 0; edge < right.edge_class.size(); ++edge) {
        INFO("edge " << edge);
        for (int c = 0; c < 5; ++c)
            if (static_cast<EdgeClass>(c) != right.edge_class[edge])
                CHECK(
                    differs([&](Partition& p) { p.edge_class[edge] = static_cast<EdgeClass>(c); }));
        CHECK(differs([&](Partition& p) { p.opposite[edge] = edge; }));
    }
    for (FaceId face = 0; face < right.face_count(); ++face) {
        INFO("face " << face);
        CHECK(differs([&](Partition& p) { p.flipped[face] ^= 1; }));
        CHECK(differs([&](Partition& p) { p.map_of_face[face] = right.map_count; }));
    }
}
