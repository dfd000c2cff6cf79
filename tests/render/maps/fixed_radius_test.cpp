#include "tests/render/maps/within_by_hand.h"

#include <limits>

using namespace hipmap;

TEST_CASE("fixed radius: what its definition says", "[maps]")
{
    std::size_t cases = 0, cut = 0;
    for (std::uint64_t seed = 0; seed < 120; ++seed) {
        const auto ready =
            tiny::ready(tiny::make_scene(within::kSurfaces[seed % within::kSurfaces.size()](seed)));
        const TriangleMesh& mesh = ready->scene.mesh;
        const MapSurfaces surfaces(mesh, ready->partition);
        const std::vector<Photon> photons = within::make_photons(mesh, 500, seed);
        const PhotonMaps maps = build_photon_maps(photons, ready->partition, {50});
        const within::ByHand by_hand{surfaces, photons};
        EstimateScratch scratch;
        for (std::uint64_t i = 0; i < 25; ++i) {
            const auto [query, radii] = within::random_query(mesh, seed, i);
            INFO("seed " << seed << ", query " << i);
            within::check_same(estimate_within(maps, surfaces, query, radii, scratch),
                               by_hand.estimate(query, radii));
            cut += scratch.segments.empty() ? 0 : 1;
            ++cases;
        }
    }
    WARN(cases << " estimates by brute force, " << cut << " of them near a boundary");
    CHECK(cut > 1000);
    CHECK(cut < 3000);
}

TEST_CASE("fixed radius: nothing there, nothing found", "[maps]")
{
    const auto ready = tiny::ready(tiny::make_scene(tiny::quad()));
    const MapSurfaces surfaces(ready->scene.mesh, ready->partition);
    const std::vector<Photon> photons(20, Photon{{0.5f, 0.25f, 0}, Rgb(1), {0, 0, 1}, 0, 0});
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EstimateScratch scratch;
    for (const bool some : {false, true}) {
        const PhotonMaps maps =
            build_photon_maps(some ? photons : std::vector<Photon>(), ready->partition, {50});
        for (const glm::vec3& at : {glm::vec3(0.9f, 0.1f, 0), glm::vec3(nan)}) {
            const RadiusEstimates none =
                estimate_within(maps, surfaces, {at, {0, 0, 1}, 0, 0}, {0.1f, 0.1f, 0}, scratch);
            CHECK(none.photons == 0);
            CHECK(none.irradiance[0] == Rgb(0));
        }
        const PhotonQuery there{{0.5f, 0.25f, 0}, {0, 0, 1}, 0, 0};
        CHECK(estimate_within(maps, surfaces, there, {0, 0, 0}, scratch).irradiance[0] == Rgb(0));
    }
}
