#include "render/dissertation/level_search.h"
#include "tests/render/maps/scattered_photons.h"
#include "tests/support/tiny_scenes.h"

#include <catch2/catch.hpp>

using namespace hipmap;

namespace {

/// What a query of the mode should find, by its definition: slots of its map.
std::vector<Neighbour> find_by_hand(const DissertationMaps& maps, const Partition& partition,
                                    const PhotonQuery& query)
{
    const PhotonMap& map = *map_of_query(maps, partition, query);
    const auto passes = [&](std::uint32_t slot) {
        if (maps.options.mode == MapMode::global)
            return glm::dot(map.direction(slot), query.normal) > 0;
        return map.side == query.side &&
               partition.map_of_face[map.faces[slot]] == partition.map_of_face[query.face];
    };
    return scattered::nearest_by_hand(map, query, maps.shared.options.neighbours, passes);
}

} // namespace

TEST_CASE("find photons: every mode finds what its definition says", "[dissertation]")
{
    const auto ready = tiny::ready(tiny::make_scene(tiny::cube()));
    const TriangleMesh& mesh = ready->scene.mesh;
    const MapSurfaces surfaces(mesh, ready->partition);
    for (const MapMode mode : {MapMode::global, MapMode::shared, MapMode::thesis})
        for (const std::uint32_t k : {2u, 25u, 400u}) {
            const DissertationMaps maps = build_dissertation_maps(
                scattered::make_photons(mesh, 6000, 1), surfaces, {k}, {mode, 10});
            SearchScratch scratch;
            DissertationScratch below;
            for (std::uint64_t i = 0; i < 200; ++i) {
                const PhotonQuery query = scattered::query_at(mesh, i);
                const auto found = find_photons(maps, surfaces, query, {scratch, below});
                CHECK(brute_force::same(scattered::sorted(found, query),
                                        find_by_hand(maps, ready->partition, query)));
            }
            CHECK(scratch.statistics.queries == 200);
        }
}

TEST_CASE("find photons: thesis searches locally, skips and abandons", "[dissertation]")
{
    const auto ready = tiny::ready(tiny::make_scene(tiny::cube()));
    const TriangleMesh& mesh = ready->scene.mesh;
    const MapSurfaces surfaces(mesh, ready->partition);
    const DissertationMaps maps = build_dissertation_maps(scattered::make_photons(mesh, 6000, 1),
                                                          surfaces, {25}, {MapMode::thesis, 100});
    CHECK(maps.locals.maps.size() == 24); // 12 faces, two sides
    SearchScratch scratch;
    DissertationScratch below;
    for (std::uint64_t i = 0; i < 2000; ++i)
        find_photons(maps, surfaces, scattered::query_at(mesh, i), {scratch, below});
    const LevelStatistics& done = below.levels;
    CHECK(done.local.begun + done.local.skipped == scratch.statistics.queries);
    CHECK(done.local.skipped > 0);
    CHECK(done.local.abandoned > 0);
    CHECK(done.local.abandoned < done.local.begun);
}

TEST_CASE("find photons: a face with fewer photons than the minimum has no local map",
          "[dissertation]")
{
    const auto ready = tiny::ready(tiny::make_scene(tiny::cube()));
    const TriangleMesh& mesh = ready->scene.mesh;
    const MapSurfaces surfaces(mesh, ready->partition);
    const std::vector<Photon> photons = scattered::make_photons(mesh, 3000, 4);
    std::vector<std::uint32_t> count(2 * mesh.face_count(), 0);
    for (const Photon& photon : photons)
        ++count[2 * photon.face + photon.side];
    const std::uint32_t minimum = count[0]; // exactly as many as one of them has
    const DissertationMaps maps =
        build_dissertation_maps(photons, surfaces, {25}, {MapMode::thesis, minimum});
    for (std::size_t key = 0; key < count.size(); ++key)
        CHECK((maps.locals.of_face[key] != kNone) == (count[key] >= minimum));
}

TEST_CASE("limiting radius: distance to the nearest connected edge alone", "[dissertation]")
{
    const auto ready = tiny::ready(tiny::make_scene(tiny::quad()));
    // The diagonal is the only connected edge of the square's two faces.
    const glm::vec3 point(0.75f, 0.25f, 0);
    CHECK(limiting_radius(ready->scene.mesh, ready->partition, 0, point) ==
          Approx(0.5 / std::sqrt(2.0)));
    const auto alone = tiny::ready(tiny::make_scene(tiny::fan(3)));
    CHECK(limiting_radius(alone->scene.mesh, alone->partition, 0, {0, 0, 0}) == 0);
    const auto one = tiny::ready(
        tiny::make_scene(tiny::make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}})));
    CHECK(std::isinf(limiting_radius(one->scene.mesh, one->partition, 0, {0.2f, 0.2f, 0})));
}

TEST_CASE("level search: no photons, nothing found", "[dissertation]")
{
    const auto ready = tiny::ready(tiny::make_scene(tiny::cube()));
    const MapSurfaces surfaces(ready->scene.mesh, ready->partition);
    for (const MapMode mode :
         {MapMode::global, MapMode::shared, MapMode::thesis, MapMode::hierarchical}) {
        const DissertationMaps maps = build_dissertation_maps({}, surfaces, {50}, {mode});
        SearchScratch scratch;
        DissertationScratch below;
        const PhotonQuery query = scattered::query_at(ready->scene.mesh, 0);
        CHECK(find_photons(maps, surfaces, query, {scratch, below}).slots.empty());
        CHECK(maps.shared.maps.empty());
    }
}
