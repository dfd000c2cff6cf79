#include "preprocess/partition/connected_edges.h"
#include "preprocess/partition/share_maps.h"
#include "tests/support/tiny_meshes.h"

#include <catch2/catch.hpp>

#include <map>

using namespace hipmap;

namespace {

/// The thesis' Algorithm 2: every face without a map gets a new one, and wherever a connected
/// edge leads to another map, all faces of that map are renamed.
std::vector<MapId> rename_maps(const std::vector<EdgeClass>& edge_class,
                               const std::vector<std::uint32_t>& opposite)
{
    const auto faces = static_cast<FaceId>(edge_class.size() / 3);
    std::vector<MapId> map(faces, kNone);
    for (FaceId a = 0; a < faces; ++a) {
        if (edge_class[3 * a] == EdgeClass::degenerate)
            continue;
        if (map[a] == kNone)
            map[a] = a;
        for (std::uint32_t edge = 3 * a; edge < 3 * a + 3; ++edge) {
            if (edge_class[edge] != EdgeClass::connected)
                continue;
            const FaceId b = opposite[edge] / 3;
            const MapId old = map[b];
            map[b] = map[a];
            for (MapId& other : map)
                if (old != kNone && other == old)
                    other = map[a];
        }
    }
    return map;
}

/// The same groups with ids by lowest face.
std::vector<MapId> renumbered(const std::vector<MapId>& maps)
{
    std::map<MapId, MapId> number;
    std::vector<MapId> out;
    for (const MapId map : maps) {
        const auto next = static_cast<MapId>(number.size());
        out.push_back(map == kNone ? kNone : number.try_emplace(map, next).first->second);
    }
    return out;
}

} // namespace

TEST_CASE("share_maps: ids go by lowest face, degenerate faces have none", "[partition]")
{
    using enum EdgeClass;
    const std::vector<EdgeClass> edge_class{
        connected,  border,      border,    border, border, border, degenerate, degenerate,
        degenerate, unconnected, connected, border, border, border, unconnected};
    const std::vector<std::uint32_t> opposite{
        10, kNone, kNone, kNone, kNone, kNone, kNone, kNone, kNone, 14, 0, kNone, kNone, kNone, 9};
    const SharedMaps maps = share_maps(edge_class, opposite);
    CHECK(maps.map_of_face == std::vector<MapId>{0, 1, kNone, 0, 2});
    CHECK(maps.count == 3);
}

TEST_CASE("share_maps: no faces, no maps", "[partition]")
{
    CHECK(share_maps({}, {}).count == 0);
}

TEST_CASE("share_maps: the same groups as the thesis' quadratic algorithm", "[partition]")
{
    for (std::uint64_t seed = 0; seed < 1000; ++seed) {
        const TriangleMesh mesh = tiny::random_mesh(seed, 5 + seed % 40, 1 + seed % 60);
        const HalfEdges edges = find_half_edges(mesh, weld_vertices(mesh.positions));
        const EdgeClasses classes = classify_edges(mesh, edges, 1.2);
        const SharedMaps maps = share_maps(classes.edge_class, edges.opposite);
        REQUIRE(maps.map_of_face == renumbered(rename_maps(classes.edge_class, edges.opposite)));
    }
}
