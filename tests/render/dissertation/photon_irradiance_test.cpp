#include "common/math/sampling.h"
#include "common/rays/surface_point.h"
#include "render/dissertation/dissertation_maps.h"
#include "tests/support/hard_surfaces.h"
#include "tests/support/tiny_scenes.h"

#include <catch2/catch.hpp>
#include <tbb/global_control.h>

#include <limits>

using namespace hipmap;

namespace {

/// Photons that fall on the sides they are stored on.
std::vector<Photon> scatter_evenly(const TriangleMesh& mesh, std::size_t count)
{
    std::vector<Photon> photons;
    for (std::size_t i = 0; i < count; ++i) {
        RandomSequence random(4, RandomStream::photons, 0, i);
        const auto face =
            static_cast<FaceId>(random.next() * static_cast<float>(mesh.face_count()));
        const SurfacePoint at = surface_point(mesh, face, sample_triangle(random.next2()));
        const bool front = random.next() < 0.7f;
        photons.push_back({at.position, Rgb(random.next(), 1, 0.1f),
                           front ? at.geometric_normal : -at.geometric_normal, face,
                           static_cast<std::uint8_t>(front ? 0 : 1)});
    }
    return photons;
}

/// The nearest photon with an estimate that may answer, by looking at all of them.
std::optional<Rgb> nearest_by_hand(const PhotonIrradiance::Map& map, const PhotonQuery& query)
{
    std::optional<Rgb> nearest;
    float nearest2 = std::numeric_limits<float>::infinity();
    for (std::uint32_t slot = 0; slot < map.tree.size; ++slot) {
        const glm::vec3 d = map.tree.position(slot) - query.position;
        if (glm::dot(d, d) < nearest2 &&
            glm::dot(map.normals[slot], query.normal) > std::sqrt(0.5f)) {
            nearest2 = glm::dot(d, d);
            nearest = map.irradiance[slot];
        }
    }
    return nearest;
}

} // namespace

TEST_CASE("photon irradiance: at the photons the estimate, elsewhere that of the nearest",
          "[dissertation]")
{
    std::size_t cases = 0;
    for (const TriangleMesh& mesh :
         {tiny::cube(), tiny::hairpin(3, 0.05f), tiny::uv_sphere(12, 8)}) {
        const auto ready = tiny::ready(tiny::make_scene(mesh));
        const Partition& partition = ready->partition;
        const MapSurfaces surfaces(ready->scene.mesh, partition);
        for (const MapMode mode : {MapMode::global, MapMode::shared, MapMode::hierarchical}) {
            const IrradianceOptions options{3, mode == MapMode::shared};
            const DissertationMaps built = build_dissertation_maps(
                scatter_evenly(ready->scene.mesh, 2000), surfaces, {20}, {mode, 100});
            const PhotonMaps& maps = built.shared;
            const PhotonIrradiance cache = estimate_at_photons(built, surfaces, options);
            REQUIRE(cache.maps.size() == maps.maps.size());
            TreeScratch scratch;
            ChosenScratch estimates;
            for (std::size_t m = 0; m < maps.maps.size(); ++m)
                for (std::uint32_t slot = 0; slot < maps.maps[m].tree.size; slot += 9) {
                    const PhotonMap& map = maps.maps[m];
                    PhotonQuery query{map.tree.position(slot), surfaces.normals[map.faces[slot]],
                                      map.faces[slot], map.side};
                    const bool behind = mode == MapMode::global
                                            ? glm::dot(map.direction(slot), query.normal) < 0
                                            : map.side == 1;
                    query.normal *= behind ? -1.0f : 1.0f;
                    if (options.bounded)
                        query.radius = dissertation::even_radius(built, surfaces, query);
                    CHECK(nearest_irradiance(cache, built, partition, query, scratch) ==
                          dissertation::estimate_irradiance(built, surfaces, query, estimates));
                    query.position += glm::vec3(0.03f, -0.02f, 0.01f);
                    CHECK(nearest_irradiance(cache, built, partition, query, scratch) ==
                          nearest_by_hand(cache.maps[m], query));
                    ++cases;
                }
        }
    }
    WARN(cases << " photons and as many points beside them");
    CHECK(cases > 1500);
}

TEST_CASE("photon irradiance: no photon that faces the same way, no answer", "[dissertation]")
{
    const auto ready = tiny::ready(tiny::make_scene(tiny::quad()));
    const MapSurfaces surfaces(ready->scene.mesh, ready->partition);
    const std::vector<Photon> photons(5, Photon{{0.5f, 0.25f, 0}, Rgb(1), {0, 0, 1}, 0, 0});
    TreeScratch scratch;
    const MapMode mode = GENERATE(MapMode::global, MapMode::shared);
    for (const bool some : {false, true}) {
        const DissertationMaps maps = build_dissertation_maps(
            some ? photons : std::vector<Photon>(), surfaces, {3}, {mode, 100});
        const PhotonIrradiance cache = estimate_at_photons(maps, surfaces, {});
        const auto ask = [&](const glm::vec3& normal, std::uint8_t side) {
            const PhotonQuery query{{0.1f, 0.1f, 0}, normal, 0, side};
            return nearest_irradiance(cache, maps, ready->partition, query, scratch).has_value();
        };
        CHECK(ask({0, 0, 1}, 0) == some);
        CHECK_FALSE(ask({0, 0, -1}, 1));
        CHECK_FALSE(ask({1, 0, 0}, 0));
    }
}

TEST_CASE("photon irradiance: the same at any thread count", "[dissertation]")
{
    const auto ready = tiny::ready(tiny::make_scene(tiny::cube()));
    const MapSurfaces surfaces(ready->scene.mesh, ready->partition);
    const DissertationMaps maps = build_dissertation_maps(
        scatter_evenly(ready->scene.mesh, 20'000), surfaces, {20}, {MapMode::hierarchical, 100});
    std::vector<PhotonIrradiance> caches;
    for (const std::size_t threads : {1, 3}) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        caches.push_back(estimate_at_photons(maps, surfaces, {2, false}));
    }
    for (std::size_t m = 0; m < maps.shared.maps.size(); ++m)
        CHECK(caches[0].maps[m].irradiance == caches[1].maps[m].irradiance);
}
