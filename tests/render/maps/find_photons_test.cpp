#include "tests/render/maps/scattered_photons.h"
#include "tests/support/tiny_scenes.h"

#include <catch2/catch.hpp>

using namespace hipmap;

TEST_CASE("find photons: the k nearest of the query's map and side, listed and added up", "[maps]")
{
    const auto ready = tiny::ready(tiny::make_scene(tiny::cube()));
    const TriangleMesh& mesh = ready->scene.mesh;
    const Partition& partition = ready->partition;
    for (const std::uint32_t k : {2u, 25u, 400u}) {
        const PhotonMaps maps =
            build_photon_maps(scattered::make_photons(mesh, 6000, 1), partition, {k});
        SearchScratch scratch;
        for (std::uint64_t i = 0; i < 200; ++i) {
            const PhotonQuery query = scattered::query_at(mesh, i);
            const PhotonMap& map = *map_of_query(maps, partition, query);
            const auto found = find_photons(maps, partition, query, scratch);
            const auto of_the_map = [&](std::uint32_t slot) {
                return map.side == query.side &&
                       partition.map_of_face[map.faces[slot]] == partition.map_of_face[query.face];
            };
            CHECK(brute_force::same(scattered::sorted(found, query),
                                    scattered::nearest_by_hand(map, query, k, of_the_map)));
            const FoundSum sum = sum_photons(maps, partition, query, scratch);
            CHECK(sum.nearest.photons == found.slots.size());
            CHECK(sum.nearest.farthest2 == found.farthest2);
        }
        CHECK(scratch.statistics.queries == 400);
    }
}

TEST_CASE("photon maps: no photons, nothing found", "[maps]")
{
    const auto ready = tiny::ready(tiny::make_scene(tiny::cube()));
    const PhotonMaps maps = build_photon_maps({}, ready->partition, {50});
    SearchScratch scratch;
    const PhotonQuery query = scattered::query_at(ready->scene.mesh, 0);
    CHECK(find_photons(maps, ready->partition, query, scratch).slots.empty());
    CHECK(maps.maps.empty());
}
