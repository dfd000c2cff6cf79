#include "preprocess/partition/contacts.h"
#include "tests/preprocess/partition/posed_partition.h"

#include <catch2/catch.hpp>

#include <set>

using namespace hipmap;
using tiny::in_all_poses;
using tiny::partition_of;
using tiny::total_length;

namespace {

/// A rectangle with corner `a` and sides `u` and `v`, facing along their cross product: 2 faces,
/// the first with the side u.
TriangleMesh rectangle(const glm::vec3& a, const glm::vec3& u, const glm::vec3& v)
{
    return tiny::make_mesh({a, a + u, a + u + v, a + v}, {{0, 1, 2}, {0, 2, 3}});
}

/// A floor of 4 x 4 about the origin in y = 0, facing up, its diagonal from (-2, -2) to (2, 2).
TriangleMesh floor_quad()
{
    return rectangle({-2, 0, -2}, {0, 0, 4}, {4, 0, 0});
}

/// A cube of side 1/2 whose lowest point is at height `y`.
TriangleMesh box_at(float x, float y, float z)
{
    TriangleMesh box = tiny::cube();
    for (glm::vec3& p : box.positions)
        p = 0.5f * p + glm::vec3(x, y + 0.25f, z);
    return box;
}

std::size_t count_of(const Partition& p, MapId map)
{
    return static_cast<std::size_t>(std::ranges::count(p.contacts, map, &MapContact::map));
}

} // namespace

TEST_CASE("contacts: a box on a floor bounds the floor's map round its foot", "[partition]")
{
    in_all_poses(tiny::together(floor_quad(), box_at(1, 0, -1)), [](const Partition& p, double s) {
        REQUIRE(p.map_count == 7);
        REQUIRE(p.contacts.size() == 4);
        REQUIRE(count_of(p, 0) == 4);
        REQUIRE(total_length(p, 0) == Approx(4 * 0.5 * s).epsilon(1e-4));
        REQUIRE(p.bridged_edges.empty());
    });
    // The sides' feet are edges of the sides, so only the floor gains anything.
    const Partition p = partition_of(tiny::together(floor_quad(), box_at(1, 0, -1)));
    for (const MapContact& contact : p.contacts) {
        CHECK(contact.a.y == 0);
        CHECK(contact.b.y == 0);
        for (const glm::vec3& end : {contact.a, contact.b}) {
            CHECK(std::abs(std::abs(end.x - 1) - 0.25f) < 1e-6f);
            CHECK(std::abs(std::abs(end.z + 1) - 0.25f) < 1e-6f);
        }
    }
}

TEST_CASE("contacts: a box over the floor's diagonal is bounded in both faces without a gap",
          "[partition]")
{
    in_all_poses(tiny::together(floor_quad(), box_at(0, 0, 0)), [](const Partition& p, double s) {
        REQUIRE(count_of(p, 0) >= 4);
        REQUIRE(count_of(p, 0) <= 8);
        REQUIRE(total_length(p, 0) >= 2 * s * (1 - 1e-6));
        REQUIRE(p.contacts.size() == count_of(p, 0));
    });
}

TEST_CASE("contacts: a box through a floor bounds the floor and the four sides", "[partition]")
{
    const TriangleMesh mesh = tiny::together(floor_quad(), box_at(1, -0.2f, -1));
    in_all_poses(mesh, [](const Partition& p, double s) {
        REQUIRE(p.map_count == 7);
        REQUIRE(total_length(p, 0) == Approx(2 * s).epsilon(1e-4));
        REQUIRE(p.contacts.size() == 16); // every side is two faces
        std::multiset<int> by_map;
        for (MapId map = 1; map < 7; ++map) {
            by_map.insert(static_cast<int>(count_of(p, map)));
            if (count_of(p, map) > 0)
                REQUIRE(total_length(p, map) == Approx(0.5 * s).epsilon(1e-4));
        }
        REQUIRE(by_map == std::multiset<int>{0, 0, 2, 2, 2, 2});
    });
}

TEST_CASE("contacts: a box above the floor by more than rounding touches nothing", "[partition]")
{
    CHECK(partition_of(tiny::together(floor_quad(), box_at(1, 1e-3f, -1))).contacts.empty());
    CHECK(partition_of(tiny::together(floor_quad(), box_at(1, 1e-8f, -1))).contacts.size() == 4);
}

TEST_CASE("contacts: a wall on the floor's diagonal bounds it", "[partition]")
{
    const TriangleMesh wall = rectangle({-1, 0, -1}, {2, 0, 2}, {0, 1, 0});
    in_all_poses(tiny::together(floor_quad(), wall), [](const Partition& p, double s) {
        REQUIRE(p.map_count == 2);
        REQUIRE(p.contacts.size() == 1);
        REQUIRE(total_length(p, 0) == Approx(2 * std::sqrt(2.0) * s).epsilon(1e-4));
    });
}

TEST_CASE("contacts: walls that meet at their borders without sharing a vertex add nothing",
          "[partition]")
{
    // The wall stands on a part of the floor's border, which is a boundary already.
    const TriangleMesh wall = rectangle({-1, 0, 2}, {2, 0, 0}, {0, 1, 0});
    in_all_poses(tiny::together(floor_quad(), wall),
                 [](const Partition& p, double) { REQUIRE(p.contacts.empty()); });
}

TEST_CASE("contacts: nothing is found on plain cubes, spheres and folds", "[partition]")
{
    for (const TriangleMesh& mesh :
         {tiny::cube(), tiny::uv_sphere(8, 6), tiny::uv_sphere(32, 16), tiny::tetrahedron(),
          tiny::fan(100), tiny::hairpin(4, 0.01f), tiny::open_box(), tiny::bow_tie(), tiny::fin(),
          tiny::flipped_pair(), tiny::moebius(20)})
        in_all_poses(mesh, [](const Partition& p, double) {
            REQUIRE(p.contacts.empty());
            REQUIRE(p.bridged_edges.empty());
        });
}

TEST_CASE("seams: walls of separate objects that abut become one map without an edge between",
          "[partition]")
{
    const TriangleMesh one = rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    for (const float shift : {0.0f, 0.3f}) { // corner to corner, and past each other
        const TriangleMesh mesh =
            tiny::together(one, rectangle({1, shift + 1e-3f, 0}, {1, 0, 0}, {0, 1.5f, 0}));
        in_all_poses(mesh, [&](const Partition& p, double s) {
            REQUIRE(p.map_count == 1);
            REQUIRE(p.bridged_edges.size() == 2);
            // What is left of the two edges: of one below, of the other above where they overlap.
            REQUIRE(total_length(p, 0) == Approx((2.5 - 2 * (1 - shift - 1e-3)) * s).epsilon(1e-4));
        });
    }
}

TEST_CASE("seams: a floor half of which is twice as fine is one map", "[partition]")
{
    in_all_poses(tiny::t_junction_floor(4), [](const Partition& p, double) {
        REQUIRE(p.map_count == 1);
        REQUIRE(p.bridged_edges.size() == 4 + 8);
        REQUIRE(p.contacts.empty());
    });
}

TEST_CASE("seams: coincident faces share one map and one side", "[partition]")
{
    TriangleMesh other_diagonal = tiny::quad();
    other_diagonal.corners = {{0, 1, 3}, {1, 2, 3}};
    for (const TriangleMesh& mesh : {tiny::doubled(), tiny::together(tiny::quad(), tiny::quad()),
                                     tiny::together(tiny::quad(), other_diagonal)})
        in_all_poses(mesh, [](const Partition& p, double) {
            REQUIRE(p.map_count == 1);
            REQUIRE(std::set(p.flipped.begin(), p.flipped.end()).size() == 1);
            REQUIRE(p.contacts.empty());
        });
}

TEST_CASE("seams: at threshold 0 nothing is joined", "[partition]")
{
    const TriangleMesh mesh = tiny::together(tiny::quad(), tiny::quad());
    const Scene scene = tiny::make_scene(mesh);
    CHECK(build_partition(scene, {.angle_threshold = 0}).partition.map_count == 4);
}

TEST_CASE("seams: a wall on the seam keeps two floors apart or bounds their map", "[partition]")
{
    const TriangleMesh floors = tiny::together(rectangle({0, 0, 0}, {0, 0, 1}, {1, 0, 0}),
                                               rectangle({-1, 0, 0}, {0, 0, 1}, {1, 0, 0}));
    const TriangleMesh wall = rectangle({0, 0, 0}, {0, 0, 1}, {0, 1, 0});
    in_all_poses(tiny::together(floors, wall), [](const Partition& p, double) {
        REQUIRE(p.map_count == 3); // one edge of three faces
        REQUIRE(p.bridged_edges.empty());
    });
    const TriangleMesh inner = rectangle({0, 0, 0.25f}, {0, 0, 0.5f}, {0, 1, 0});
    in_all_poses(tiny::together(floors, inner), [](const Partition& p, double s) {
        REQUIRE(p.map_count == 2);
        REQUIRE(total_length(p, 0) == Approx(0.5 * s).epsilon(1e-4));
    });
}

TEST_CASE("seams: faces that touch in a point, face away or are out of the plane stay apart",
          "[partition]")
{
    const TriangleMesh one = rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    for (const TriangleMesh& other : {rectangle({1, 1, 0}, {1, 0, 0}, {0, 1, 0}),
                                      rectangle({1, 0.1f, 0}, {0, 0.7f, 0}, {1, 0, 0}),
                                      rectangle({1, 0.1f, 0}, {1, 0, 0.1f}, {0, 0.7f, 0}),
                                      rectangle({1.001f, 0.1f, 0}, {1, 0, 0}, {0, 0.7f, 0})})
        in_all_poses(tiny::together(one, other), [](const Partition& p, double) {
            REQUIRE(p.map_count == 2);
            REQUIRE(p.bridged_edges.empty());
        });
}

TEST_CASE("contacts: a tree of boxes finds the pairs that a loop over all pairs finds",
          "[partition]")
{
    std::size_t total = 0, of_one_map = 0;
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        TriangleMesh mesh = tiny::random_mesh(seed, 40, 20 + 10 * (seed % 30));
        if (seed % 2)
            tiny::jitter(mesh, 0.1f, seed);
        const double angle = seed < 30 ? glm::pi<double>() / 6 : 3;
        const PartitionResult result =
            build_partition(tiny::make_scene(mesh), {.angle_threshold = angle});
        const Partition& p = result.partition;
        const ContactScene scene{mesh,          p.edge_class,    p.opposite,
                                 p.map_of_face, p.bridged_edges, p.position_error};
        std::vector<MapContact> expected;
        for (FaceId f = 0; f < mesh.face_count(); ++f)
            for (FaceId g = f + 1; g < mesh.face_count(); ++g)
                if (p.map_of_face[f] != kNone && p.map_of_face[g] != kNone)
                    append_contacts(scene, f, g, expected);
        sort_contacts(expected);
        std::vector<FaceId> faces;
        for (FaceId f = 0; f < mesh.face_count(); ++f)
            if (p.map_of_face[f] != kNone)
                faces.push_back(f);
        const FaceTree tree(mesh, faces);
        const std::vector<std::uint8_t> all(p.map_count, 1);
        std::vector<MapContact> found;
        for (const MadeContact& made : find_contacts(scene, tree, all).contacts)
            found.push_back(made.contact);
        const std::size_t of_pairs = found.size();
        for (const MadeContact& made :
             find_own_contacts(scene, tree, p.self_distance, all).contacts)
            found.push_back(made.contact);
        of_one_map += found.size() - of_pairs;
        sort_contacts(found);
        REQUIRE(found == expected);
        total += expected.size();
    }
    CHECK(total > 1000);
    CHECK(of_one_map > 300);
}

TEST_CASE("of faces that all cut through each other only so many pairs are looked at",
          "[partition]")
{
    // Tall thin triangles through one vertical axis, each turned a little more, as a file made to
    // be slow would have them.
    constexpr int kFaces = 1500;
    std::vector<glm::vec3> positions;
    std::vector<glm::uvec3> corners;
    for (std::uint32_t i = 0; i < kFaces; ++i) {
        const float angle = static_cast<float>(i) * std::numbers::pi_v<float> / kFaces;
        const glm::vec3 side(std::cos(angle), 0, std::sin(angle));
        const float low = -0.5f + 1e-4f * static_cast<float>(i);
        positions.insert(positions.end(),
                         {side + glm::vec3(0, low, 0), -side + glm::vec3(0, low, 0),
                          glm::vec3(0.01f * side.z, 1, 0.01f * side.x)});
        corners.emplace_back(3 * i, 3 * i + 1, 3 * i + 2);
    }
    const Scene scene = tiny::make_scene(tiny::make_mesh(std::move(positions), std::move(corners)));
    const PartitionResult result = build_partition(scene, {});
    CHECK(result.summary.given_up > 0);
    CHECK(result.summary.given_up <= 4 * kFaces); // faces and their edges
    CHECK(result.summary.contacts > 0);
    CHECK(result.summary.contacts <= 2 * 1024 * kFaces);
}
