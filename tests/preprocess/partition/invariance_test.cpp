#include "preprocess/partition/connected_edges.h"
#include "tests/support/hard_surfaces.h"
#include "tests/support/properties.h"
#include "tests/support/same_partition.h"

#include <catch2/catch.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <filesystem>

using namespace hipmap;

namespace {

constexpr double kThreshold = std::numbers::pi / 6;

// Rounding may change what lies at a threshold, so scenes keep away from these.

/// Of all faces but those with a vertex twice, over the longest side.  Rounding to float turns a
/// face by up to 2^-24 over its height: 4e-6 rad.
constexpr double kLeastHeight = 1.0 / 64;

/// Edges are kept farther than this from the angle at which their class changes.
constexpr double kLeastAngle = 5e-5;

/// Positions are kept farther apart than this, or are the same: many tolerances.
constexpr float kLeastDistance = 1e-4f;

/// Leaves out faces that rounding could turn, or from which it could take the area.
TriangleMesh without_slivers(TriangleMesh mesh)
{
    std::vector<glm::uvec3> corners;
    for (FaceId face = 0; face < mesh.face_count(); ++face) {
        const glm::uvec3& c = mesh.corners[face];
        const glm::vec3 &p = mesh.positions[c.x], &q = mesh.positions[c.y],
                        &r = mesh.positions[c.z];
        const double longest =
            std::max({glm::distance(p, q), glm::distance(q, r), glm::distance(r, p)});
        if (p == q || q == r || r == p || 2 * face_area(mesh, face) > kLeastHeight * longest)
            corners.push_back(c);
    }
    return tiny::make_mesh(std::move(mesh.positions), std::move(corners));
}

/// Whether rounding can neither change the class of an edge nor make two positions one.
bool is_clear_of_thresholds(const TriangleMesh& mesh)
{
    for (const glm::vec3& p : mesh.positions)
        for (const glm::vec3& q : mesh.positions)
            if (p != q && glm::distance(p, q) < kLeastDistance)
                return false;
    const HalfEdges edges = find_half_edges(mesh, weld_vertices(mesh.positions));
    return classify_edges(mesh, edges, kThreshold - kLeastAngle).edge_class ==
           classify_edges(mesh, edges, kThreshold + kLeastAngle).edge_class;
}

TriangleMesh random_surface(std::uint64_t seed, std::uint32_t kind, std::uint32_t cells)
{
    RandomSequence random(seed, RandomStream::pictures, 0, 2);
    const float gap = 0.03f + 0.2f * random.next();
    const std::array<std::function<TriangleMesh()>, 10> makers{
        [&] { return tiny::slit_floor(cells, gap); },
        [&] { return tiny::hairpin(cells, gap); },
        [&] { return tiny::thin_shell(6 + 2 * cells, 4 * gap); },
        [&] { return tiny::t_junction_floor(cells); },
        [&] { return tiny::notched_fan(9 + 4 * cells, 2 + cells); },
        [&] { return tiny::random_mesh(seed, 9, 8 * cells); },
        [&] { return tiny::random_mesh(seed, 20, 8 * cells); },
        [&] { return tiny::moebius(2 + 3 * cells); },
        [&] { return tiny::uv_sphere(4 * cells, 2 * cells); },
        [&] { return tiny::open_box(); },
    };
    TriangleMesh mesh = makers[kind % makers.size()]();
    if (random.next() < 0.5f)
        tiny::jitter(mesh, 0.02f, seed);
    if (random.next() < 0.3f)
        tiny::flip(mesh,
                   static_cast<FaceId>(random.next() * static_cast<float>(mesh.face_count())));
    return mesh;
}

/// One surface, or two that may touch or cut through each other.
TriangleMesh random_scene()
{
    const auto surface = [] {
        const auto seed = *rc::gen::inRange<std::uint64_t>(0, 1000000);
        const auto kind = *rc::gen::inRange<std::uint32_t>(0, 10);
        return random_surface(seed, kind, *rc::gen::inRange<std::uint32_t>(1, 5));
    };
    TriangleMesh mesh = surface();
    if (*rc::gen::arbitrary<bool>())
        mesh = tiny::together(mesh, surface());
    return without_slivers(std::move(mesh));
}

/// [F] a permutation.
std::vector<FaceId> shuffled(std::size_t faces, std::uint64_t seed)
{
    std::vector<FaceId> order(faces);
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::sort(order, {}, [&](FaceId face) { return mix_bits(mix_bits(seed) + face); });
    return order;
}

/// Ways to write a mesh into a file.
std::vector<tiny::Placement> placements(const std::vector<FaceId>& order, std::uint64_t seed)
{
    const glm::dmat4 one(1.0);
    const glm::dmat4 moved = glm::translate(one, {1e6, -1e6, 1e6});
    const glm::dmat4 turned(glm::mat4_cast(glm::dquat(tiny::random_rotation(seed))));
    return {
        {.name = "moved", .to_world = moved},
        {.name = "scaled by 1e-6", .to_world = glm::scale(one, glm::dvec3(1e-6))},
        {.name = "scaled by 1e6", .to_world = glm::scale(one, glm::dvec3(1e6))},
        {.name = "rotated", .to_world = turned},
        {.name = "mirrored", .to_world = glm::scale(one, glm::dvec3(1, -1, 1))},
        {.name = "shuffled", .order = order},
        {.name = "wound the other way", .turned = true},
        {.name = "cut into objects", .objects = 3},
        {.name = "cut into mirrored objects", .objects = 4, .some_mirrored = true},
        {.name = "all at once",
         .to_world = moved * turned * glm::scale(one, glm::dvec3(1e3, -1e3, 1e3)),
         .order = order,
         .turned = true,
         .objects = 5,
         .some_mirrored = true},
    };
}

/// What differs first between a mesh as it is and as placed; counts the placements.
std::string difference_of_placements(const TriangleMesh& mesh, std::uint64_t seed,
                                     std::size_t& cases)
{
    const tiny::Partitioned base(tiny::placed(mesh, {}));
    // Where a surface with one side is cut depends on its first face.
    const HalfEdges edges = find_half_edges(mesh, weld_vertices(mesh.positions));
    const std::vector<FaceId> order =
        edges.defects.cut_edges > 0 ? std::vector<FaceId>() : shuffled(mesh.face_count(), seed);
    for (const tiny::Placement& placement : placements(order, seed)) {
        const tiny::Partitioned other(tiny::placed(mesh, placement));
        const std::string found = tiny::PartitionComparison(base, other, placement).difference();
        if (!found.empty())
            return placement.name + ": " + found;
        ++cases;
    }
    return {};
}

} // namespace

TEST_CASE("invariance: place, size, pose, order, winding and objects do not change the partition",
          "[partition]")
{
    std::size_t cases = 0;
    const bool same = holds("partitions of random scenes", 150, [&cases] {
        const TriangleMesh mesh = random_scene();
        RC_PRE(mesh.face_count() > 0 && is_clear_of_thresholds(mesh));
        const auto seed = *rc::gen::inRange<std::uint64_t>(0, 1000000);
        RC_ASSERT(difference_of_placements(mesh, seed, cases) == "");
    });
    CHECK(same);
    WARN(cases << " cases");
}

TEST_CASE("invariance: the partition of a bundled scene is the same wherever it is", "[partition]")
{
    const tiny::GltfFile file =
        tiny::read_glb(std::filesystem::path(HIPMAP_SOURCE_DIR) / "assets/cornell.glb");
    const tiny::Partitioned base(file);
    REQUIRE(is_clear_of_thresholds(base.scene.mesh));
    std::size_t cases = 0;
    CHECK(difference_of_placements(base.scene.mesh, 1, cases) == "");
    for (const tiny::Placement& placement : placements({}, 1)) {
        if (placement.to_world == glm::dmat4(1.0))
            continue;
        INFO(placement.name);
        tiny::GltfFile moved = file;
        tiny::hang_below(moved, placement.to_world);
        const tiny::Placement root{.name = placement.name, .to_world = placement.to_world};
        CHECK(tiny::PartitionComparison(base, tiny::Partitioned(moved), root).difference() == "");
        ++cases;
    }
    WARN(cases << " cases");
}

TEST_CASE("invariance: a partition that is not the same is found out", "[partition]")
{
    const TriangleMesh mesh = tiny::together(tiny::t_junction_floor(2), tiny::cube());
    const tiny::Partitioned right(tiny::placed(mesh, {}));
    const Partition& p = right.partition;
    REQUIRE(p.contacts.size() > 0);
    REQUIRE(p.bridged_edges.size() > 0);
    const auto differs = [&](const auto& spoil) {
        tiny::Partitioned wrong = right;
        spoil(wrong.partition);
        return tiny::PartitionComparison(right, wrong, {}).difference() != "";
    };
    CHECK(!differs([](Partition&) {}));
    CHECK(differs([](Partition& q) { q.map_of_face[0] = q.map_count; }));
    CHECK(differs([](Partition& q) { ++q.map_count; }));
    CHECK(differs([](Partition& q) { q.edge_class[1] = EdgeClass::degenerate; }));
    CHECK(differs([](Partition& q) { q.opposite[2] = kNone; }));
    CHECK(differs([](Partition& q) { q.flipped[1] ^= 1; }));
    CHECK(differs([](Partition& q) { q.candidate[1] ^= 1; }));
    CHECK(differs([](Partition& q) { q.reach[1] *= 1.01f; }));
    CHECK(differs([](Partition& q) { q.kept_edges[1] ^= 7; }));
    CHECK(differs([](Partition& q) { q.bridged_edges.pop_back(); }));
    CHECK(differs([](Partition& q) { q.contacts.pop_back(); }));
    CHECK(differs([](Partition& q) { q.contacts[0].b += 0.01f; }));
}
