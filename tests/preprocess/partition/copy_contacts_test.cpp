#include "common/partition/check_partition.h"
#include "common/partition/expand_copies.h"
#include "preprocess/partition/build_partition.h"
#include "preprocess/partition/copy_contacts.h"
#include "tests/support/copied_mesh.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <map>
#include <set>

using namespace hipmap;
using tiny::place_at;
using tiny::with_copies;

namespace {

/// A floor of 4 x 4 about the origin in y = 0, facing up.
TriangleMesh floor_of_copies()
{
    return tiny::make_mesh({{-2, 0, -2}, {-2, 0, 2}, {2, 0, 2}, {2, 0, -2}},
                           {{0, 1, 2}, {0, 2, 3}});
}

/// A cube of side 0.4 that stands on y = 0 about a corner of the floor.
TriangleMesh box()
{
    TriangleMesh mesh = tiny::cube();
    for (glm::vec3& p : mesh.positions)
        p = 0.4f * p + glm::vec3(-1.5f, 0.2f, -1.5f);
    return mesh;
}

/// A ball with a map or more.
TriangleMesh ball()
{
    TriangleMesh mesh = tiny::uv_sphere(12, 8);
    for (glm::vec3& p : mesh.positions)
        p = 0.3f * p + glm::vec3(-1.4f, 0.2f, -1.4f);
    return mesh;
}

struct Both {
    Scene scene;        ///< with copies that are left
    Partition copied;   ///< of it
    Partition expanded; ///< the same of all faces
    Scene stored_scene; ///< with all faces of `scene` stored
    Partition stored;   ///< of it
    PartitionSummary copied_summary, stored_summary;
};

Both both(const TriangleMesh& mesh, const PartitionOptions& options = {})
{
    Both out;
    out.scene = tiny::make_scene(mesh);
    PartitionResult copied = build_partition_of_copies(out.scene, options);
    out.copied = copied.partition;
    out.copied_summary = copied.summary;
    out.expanded = expand_copies(out.copied, out.scene.mesh);
    out.stored_scene = out.scene;
    store_copies(out.stored_scene.mesh);
    PartitionResult stored = build_partition(out.stored_scene, options);
    out.stored = stored.partition;
    out.stored_summary = stored.summary;
    return out;
}

/// The total length of the contacts of each map.
std::map<MapId, double> lengths(const Partition& p)
{
    std::map<MapId, double> out;
    for (const MapContact& contact : p.contacts)
        out[contact.map] += glm::distance(contact.a, contact.b);
    return out;
}

/// Demands that both say the same of every face, edge and map.
void check_same(const Both& both)
{
    const Partition &a = both.expanded, &b = both.stored;
    CHECK(defect_of(both.copied).empty());
    CHECK(defect_of(a).empty());
    CHECK(a.map_count == b.map_count);
    CHECK(a.map_of_face == b.map_of_face);
    CHECK(a.edge_class == b.edge_class);
    CHECK(a.opposite == b.opposite);
    CHECK(a.flipped == b.flipped);
    CHECK(a.closed == b.closed);
    CHECK(a.bridged_edges == b.bridged_edges);
    CHECK(a.position_error == b.position_error);
    for (FaceId face = 0; face < b.face_count(); ++face)
        CHECK((a.reach[face] == b.reach[face] ||
               a.reach[face] == Approx(b.reach[face]).epsilon(1e-3)));
    const auto of_a = lengths(a), of_b = lengths(b);
    REQUIRE(of_a.size() == of_b.size());
    for (const auto& [map, length] : of_b)
        CHECK(of_a.at(map) == Approx(length).epsilon(2e-4).margin(1e-4));
    CHECK(both.copied_summary.faces == both.stored_summary.faces);
    CHECK(both.copied_summary.map_count == both.stored_summary.map_count);
    CHECK(both.copied_summary.area == Approx(both.stored_summary.area));
    CHECK(both.copied_summary.edges == both.stored_summary.edges);
    CHECK(both.copied_summary.closed_faces == both.stored_summary.closed_faces);
    CHECK(both.copied_summary.largest.area == Approx(both.stored_summary.largest.area));
}

} // namespace

TEST_CASE("copies: boxes on a floor bound its map, and each has maps of its own",
          "[partition][copies]")
{
    const Both result = both(with_copies(
        floor_of_copies(), box(),
        {place_at({1.2, 0, 0.1}), place_at({2.5, 0, 0.4}, 30), place_at({0, 0, 2.5}, 77, 1.3)}));
    check_same(result);
    CHECK(result.copied.apart.empty());
    CHECK(result.copied.copies.size() == 3);
    CHECK(result.copied.map_count == 7);
    CHECK(result.copied.all_map_count() == 25);
    CHECK(result.copied.contacts.size() == 12); // around the feet of three
    CHECK(result.copied.own_contacts.empty());
}

TEST_CASE("copies: what cuts through others bounds the maps of those alone", "[partition][copies]")
{
    const Both result = both(with_copies(
        floor_of_copies(), ball(),
        {place_at({0.45, 0.03, 0.1}, 10), place_at({0.9, 0.02, 0}, 50, 1.1, {1, 0.2, 0}),
         place_at({2, 1, 2}), place_at({1.5, 0.1, 1.4}, 120, 0.8, {1, 1, 3})}));
    check_same(result);
    CHECK(result.copied.apart.empty());
    CHECK_FALSE(result.copied.own_contacts.empty());
    std::set<MapId> bounded;
    for (const MapContact& contact : result.copied.own_contacts)
        bounded.insert(contact.map);
    const std::uint32_t alone = 2; // that which touches nothing
    for (const MapId map : bounded)
        CHECK((map < result.copied.first_map_of_copy[alone] ||
               map >= result.copied.first_map_of_copy[alone + 1]));
}

TEST_CASE("copies: those that go on across a seam are set apart, and the others are not",
          "[partition][copies]")
{
    // Tiles: the second abuts the first, the third overlaps it, the fourth lies alone, the fifth
    // shares an edge with the fourth but for a corner, the sixth stands on the first.
    TriangleMesh tile = tiny::quad();
    const Both result =
        both(with_copies(floor_of_copies(), tile,
                         {place_at({1, 0.25, 0}), place_at({0.5, -0.5, 0}), place_at({0, 0, 5}, 20),
                          place_at({3, 3, 3}), place_at({0.3, 0.2, 0}, 90)}));
    check_same(result);
    CHECK(result.copied.apart == std::vector<std::uint32_t>{0, 1, 2});
    CHECK(result.copied.copies.size() == 2); // of the heir
}

TEST_CASE("copies: those that share an edge bit for bit are set apart", "[partition][copies]")
{
    const Both result =
        both(with_copies(floor_of_copies(), tiny::quad(),
                         {place_at({1, 0, 0}), place_at({0, 0, -1}, -90, 1, {0, 1, 0}),
                          place_at({0, 3, 0}), place_at({-5, 3, 0}, 45)}));
    check_same(result);
    CHECK(std::ranges::includes(result.copied.apart, std::vector<std::uint32_t>{0, 1}));
    CHECK(result.stored.map_count < 2 + result.stored_scene.mesh.face_count() / 2);
}

TEST_CASE("copies: many in one place are set apart", "[partition][copies]")
{
    const Both result = both(with_copies(
        floor_of_copies(), ball(),
        {place_at({0, 0, 0}), place_at({0, 0, 0}), place_at({0, 0, 0}), place_at({2, 2, 2}, 3)}));
    check_same(result);
    CHECK(result.copied.apart.size() == 4);
    CHECK(result.copied.copies.empty());
}

TEST_CASE("copies: welding over a distance stores them all", "[partition][copies]")
{
    PartitionOptions options;
    options.weld_distance = 0.001;
    const Both result =
        both(with_copies(floor_of_copies(), ball(), {place_at({1, 2, 0}), place_at({2, 0, 3})}),
             options);
    check_same(result);
    CHECK(result.copied.copies.empty());
    CHECK(result.copied.apart == std::vector<std::uint32_t>{0, 1, 2});
}

TEST_CASE("copies: the partition does not depend on the order of copies", "[partition][copies]")
{
    std::vector<Similarity> places{place_at({0.45, 0.03, 0.1}, 10),
                                   place_at({0.9, 0.02, 0}, 50, 1.1), place_at({2, 0, 2}),
                                   place_at({1.5, 0.1, 1.4}, 120, 0.8)};
    const Both one = both(with_copies(floor_of_copies(), ball(), places));
    std::ranges::reverse(places);
    const Both other = both(with_copies(floor_of_copies(), ball(), places));
    CHECK(one.copied.own_contacts.size() == other.copied.own_contacts.size());
    CHECK(lengths(one.copied)[0] == Approx(lengths(other.copied)[0]).epsilon(1e-5));
}
