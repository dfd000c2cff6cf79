#include "common/math/sampling.h"
#include "common/rays/surface_point.h"
#include "render/maps/find_photons.h"
#include "tests/support/brute_force.h"
#include "tests/support/tiny_scenes.h"

#include <catch2/catch.hpp>

using namespace hipmap;

namespace {

/// Photons spread evenly over random points of random faces, on both sides.
std::vector<Photon> scatter_photons(const TriangleMesh& mesh, std::size_t count, std::uint64_t seed)
{
    std::vector<Photon> photons;
    for (std::size_t i = 0; i < count; ++i) {
        RandomSequence random(seed, RandomStream::photons, 0, i);
        const auto face =
            static_cast<FaceId>(random.next() * static_cast<float>(mesh.face_count()));
        const SurfacePoint at = surface_point(mesh, face, sample_triangle(random.next2()));
        const bool front = random.next() < 0.7f;
        photons.push_back({at.position, Rgb(random.next()),
                           front ? at.geometric_normal : -at.geometric_normal, face,
                           static_cast<std::uint8_t>(front ? 0 : 1)});
    }
    return photons;
}

PhotonQuery query_at(const TriangleMesh& mesh, std::uint64_t i)
{
    RandomSequence random(99, RandomStream::eye_paths, 0, i);
    const auto face = static_cast<FaceId>(random.next() * static_cast<float>(mesh.face_count()));
    const SurfacePoint at = surface_point(mesh, face, sample_triangle(random.next2()));
    return {at.position, at.geometric_normal, face, 0};
}

/// Nearest first; the farthest must have come last.
std::vector<Neighbour> sorted(const FoundPhotons& found, const PhotonQuery& query)
{
    std::vector<Neighbour> out;
    for (const std::uint32_t slot : found.slots) {
        const glm::vec3 d = found.map->tree.position(slot) - query.position;
        out.push_back({glm::dot(d, d), slot});
    }
    if (!out.empty()) {
        const std::uint32_t last = out.back().photon;
        std::sort(out.begin(), out.end());
        CHECK(out.back().photon == last);
        CHECK(out.back().distance2 == found.farthest2);
    }
    return out;
}

/// What a query of the mode should find, by its definition: slots of its map.
std::vector<Neighbour> find_by_hand(const PhotonMaps& maps, const Partition& partition,
                                    const PhotonQuery& query)
{
    const PhotonMap& map = *map_of_query(maps, partition, query);
    std::vector<glm::vec3> positions;
    for (std::uint32_t slot = 0; slot < map.tree.size; ++slot)
        positions.push_back(map.tree.position(slot));
    const auto passes = [&](std::uint32_t slot) {
        if (maps.options.mode == MapMode::global)
            return glm::dot(map.direction(slot), query.normal) > 0;
        return map.side == query.side &&
               partition.map_of_face[map.faces[slot]] == partition.map_of_face[query.face];
    };
    return brute_force::k_nearest(positions, query.position, maps.options.neighbours, query.radius,
                                  passes);
}

} // namespace

TEST_CASE("find photons: every mode finds what its definition says", "[maps]")
{
    const auto ready = tiny::ready(tiny::make_scene(tiny::cube()));
    const TriangleMesh& mesh = ready->scene.mesh;
    for (const MapMode mode : {MapMode::global, MapMode::shared, MapMode::thesis})
        for (const std::uint32_t k : {2u, 25u, 400u}) {
            const PhotonMaps maps = build_photon_maps(scatter_photons(mesh, 6000, 1), mesh,
                                                      ready->partition, {mode, k, 10});
            SearchScratch scratch;
            for (std::uint64_t i = 0; i < 200; ++i) {
                const PhotonQuery query = query_at(mesh, i);
                const auto found = find_photons(maps, mesh, ready->partition, query, scratch);
                CHECK(brute_force::same(sorted(found, query),
                                        find_by_hand(maps, ready->partition, query)));
            }
            CHECK(scratch.statistics.queries == 200);
        }
}

TEST_CASE("find photons: thesis searches locally, skips and abandons", "[maps]")
{
    const auto ready = tiny::ready(tiny::make_scene(tiny::cube()));
    const TriangleMesh& mesh = ready->scene.mesh;
    const PhotonMaps maps = build_photon_maps(scatter_photons(mesh, 6000, 1), mesh,
                                              ready->partition, {MapMode::thesis, 25, 100});
    CHECK(maps.locals.maps.size() == 24); // 12 faces, two sides
    SearchScratch scratch;
    for (std::uint64_t i = 0; i < 2000; ++i)
        find_photons(maps, mesh, ready->partition, query_at(mesh, i), scratch);
    const SearchStatistics& done = scratch.statistics;
    CHECK(done.local.begun + done.local.skipped == done.queries);
    CHECK(done.local.skipped > 0);
    CHECK(done.local.abandoned > 0);
    CHECK(done.local.abandoned < done.local.begun);
}

TEST_CASE("find photons: a face with fewer photons than the minimum has no local map", "[maps]")
{
    const auto ready = tiny::ready(tiny::make_scene(tiny::cube()));
    const TriangleMesh& mesh = ready->scene.mesh;
    const std::vector<Photon> photons = scatter_photons(mesh, 3000, 4);
    std::vector<std::uint32_t> count(2 * mesh.face_count(), 0);
    for (const Photon& photon : photons)
        ++count[2 * photon.face + photon.side];
    const std::uint32_t minimum = count[0]; // exactly as many as one of them has
    const PhotonMaps maps =
        build_photon_maps(photons, mesh, ready->partition, {MapMode::thesis, 25, minimum});
    for (std::size_t key = 0; key < count.size(); ++key)
        CHECK((maps.locals.of_face[key] != kNone) == (count[key] >= minimum));
}

TEST_CASE("limiting radius: distance to the nearest connected edge alone", "[maps]")
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

TEST_CASE("photon maps: no photons, nothing found", "[maps]")
{
    const auto ready = tiny::ready(tiny::make_scene(tiny::cube()));
    for (const MapMode mode : {MapMode::none, MapMode::global, MapMode::shared, MapMode::thesis,
                               MapMode::hierarchical}) {
        const PhotonMaps maps =
            build_photon_maps({}, ready->scene.mesh, ready->partition, {mode, 50, 500});
        SearchScratch scratch;
        CHECK(find_photons(maps, ready->scene.mesh, ready->partition,
                           query_at(ready->scene.mesh, 0), scratch)
                  .slots.empty());
        CHECK(maps.maps.empty());
    }
}
