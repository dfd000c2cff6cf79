#include "common/math/sampling.h"
#include "render/maps/estimate.h"
#include "tests/support/statistics.h"
#include "tests/support/tiny_scenes.h"

#include <catch2/catch.hpp>

using namespace hipmap;

namespace {

/// `count` photons of total power 1 on the unit square, evenly: irradiance 1 everywhere.
std::vector<Photon> even_square(std::size_t count, std::uint64_t seed)
{
    std::vector<Photon> photons;
    for (std::size_t i = 0; i < count; ++i) {
        RandomSequence random(seed, RandomStream::photons, 0, i);
        const glm::vec2 at = random.next2();
        photons.push_back({{at.x, at.y, 0},
                           Rgb(1.0f / static_cast<float>(count)),
                           {0, 0, 1},
                           static_cast<FaceId>(at.y <= at.x ? 0 : 1),
                           0});
    }
    return photons;
}

/// Mean estimate at each point over many sets of photons.
std::vector<RunningMean> estimates_at(const std::vector<glm::vec2>& points, std::uint32_t k,
                                      std::size_t count, float radius)
{
    const auto ready = tiny::ready(tiny::make_scene(tiny::quad()));
    const MapSurfaces surfaces(ready->scene.mesh, ready->partition);
    EstimateScratch scratch;
    std::vector<RunningMean> means(points.size());
    for (std::uint64_t seed = 0; seed < 400; ++seed) {
        const PhotonMaps maps = build_photon_maps(even_square(count, seed), ready->partition, {k});
        for (std::size_t i = 0; i < points.size(); ++i) {
            const glm::vec2& at = points[i];
            PhotonQuery query{{at.x, at.y, 0}, {0, 0, 1}, at.y <= at.x ? 0u : 1u, 0};
            query.radius = radius;
            means[i].add(estimate_irradiance(maps, surfaces, query, scratch).y);
        }
    }
    return means;
}

constexpr float kInfinite = std::numeric_limits<float>::infinity();

} // namespace

TEST_CASE("estimate: unbiased in the middle, at an edge and in a corner", "[maps]")
{
    for (const std::uint32_t k : {2u, 10u, 50u})
        for (const RunningMean& mean : estimates_at({{0.5f, 0.4f},
                                                     {0.5f, 0.0f},
                                                     {1, 0.5f},
                                                     {0, 0},
                                                     {1, 1},
                                                     {0.99f, 0.01f},
                                                     {0.3f, 0.02f}},
                                                    k, 1000, kInfinite))
            CHECK(std::abs(mean.z_score(1)) < kMostZ);
}

TEST_CASE("estimate: unbiased where the radius holds fewer than k", "[maps]")
{
    for (const RunningMean& mean : estimates_at({{0.5f, 0.4f}, {0, 0.3f}, {1, 1}}, 500, 1000, 0.2f))
        CHECK(std::abs(mean.z_score(1)) < kMostZ);
}

TEST_CASE("estimate: a map with fewer than k photons is spread over its area", "[maps]")
{
    const RunningMean mean = estimates_at({{0.2f, 0.7f}}, 50, 20, kInfinite)[0];
    CHECK(mean.mean() == Approx(1.0).epsilon(1e-5));
}

TEST_CASE("estimate: coincident photons give a finite number", "[maps]")
{
    const auto ready = tiny::ready(tiny::make_scene(tiny::quad()));
    const MapSurfaces surfaces(ready->scene.mesh, ready->partition);
    std::vector<Photon> photons(100, Photon{{0.5f, 0.25f, 0}, Rgb(1), {0, 0, 1}, 0, 0});
    const PhotonMaps maps = build_photon_maps(photons, ready->partition, {50});
    EstimateScratch scratch;
    const Rgb value =
        estimate_irradiance(maps, surfaces, {{0.5f, 0.25f, 0}, {0, 0, 1}, 0, 0}, scratch);
    CHECK(is_finite(value));
}
