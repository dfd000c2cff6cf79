#include "common/math/sampling.h"
#include "render/dissertation/dissertation.h"
#include "tests/support/even_room_means.h"
#include "tests/support/tiny_scenes.h"

#include <catch2/catch.hpp>

using namespace hipmap;

namespace {

const DissertationOptions kPlain{MapMode::shared, 500, EstimateForm::thesis};

} // namespace

TEST_CASE("estimate: the thesis' form is high by k/(k-1), ours is not", "[dissertation]")
{
    for (const std::uint32_t k : {5u, 25u, 100u}) {
        const std::vector<glm::vec2> inside{{0.3f, 0.25f}}; // far enough from edges and each other
        const RunningMean ours = tiny::means_in_even_room(inside, {{k}, {}, 6000, 250})[0];
        const RunningMean plain = tiny::means_in_even_room(inside, {{k}, kPlain, 6000, 250})[0];
        const double high = double(k) / (k - 1);
        INFO("k = " << k << ": ours " << ours.mean() << ", z " << ours.z_score(1)
                    << "; thesis' form " << plain.mean() << ", z from k/(k-1) "
                    << plain.z_score(high) << ", from 1 " << plain.z_score(1));
        CHECK(std::abs(ours.z_score(1)) < kMostZ);
        CHECK(std::abs(plain.z_score(high)) < kMostZ);
    }
}

TEST_CASE("estimate: the thesis' form falls to a half at an edge and a quarter in a corner",
          "[dissertation]")
{
    const std::vector<glm::vec2> points{{0, 0.5f}, {0, 0}, {0.03f, 0.5f}, {0.5f, 0.5f}};
    const auto means = tiny::means_in_even_room(points, {{50}, kPlain, 30'000, 75});
    const double high = 50.0 / 49;
    CHECK(std::abs(means[0].z_score(0.5 * high)) < kMostZ);
    CHECK(std::abs(means[1].z_score(0.25 * high)) < kMostZ);
    CHECK(means[2].mean() > means[0].mean() + 0.05);
    CHECK(means[2].mean() < means[3].mean() - 0.05);
}

TEST_CASE("estimate: the thesis' form drops photons of the other side once they are chosen",
          "[dissertation]")
{
    const auto ready = tiny::ready(tiny::make_scene(tiny::floor_at(0, 1)));
    const MapSurfaces surfaces(ready->scene.mesh, ready->partition);
    std::vector<Photon> photons;
    for (int i = 0; i < 20; ++i) {
        const bool front = i % 2 == 0;
        const float x = 0.01f * static_cast<float>(i);
        photons.push_back({{x, 0, 0.1f}, Rgb(1), {0, front ? 1 : -1, 0}, 0, std::uint8_t(!front)});
    }
    const PhotonQuery query{{0, 0, 0.1f}, {0, 1, 0}, 0, 0};
    ChosenScratch scratch;
    for (const MapMode mode : {MapMode::global, MapMode::shared, MapMode::thesis}) {
        const ChosenMaps maps =
            build_chosen_maps(photons, surfaces, {10}, {mode, 5, EstimateForm::thesis});
        const double expected =
            5 / (kPi * 0.09 * 0.09); // five of ten face up, the tenth is at 0.09
        CHECK(estimate_irradiance(maps, surfaces, query, scratch).y == Approx(expected));
    }
}

TEST_CASE("estimate: one map without boundaries darkens at an edge, as it must", "[dissertation]")
{
    const auto ready = tiny::ready(tiny::make_scene(tiny::quad()));
    const MapSurfaces surfaces(ready->scene.mesh, ready->partition);
    const std::vector<glm::vec2> points{{0.5f, 0.5f}, {0.5f, 0}, {0, 0}};
    const std::vector<double> truth{1, 0.5, 0.25};
    ChosenScratch scratch;
    std::vector<RunningMean> means(points.size());
    for (std::uint64_t seed = 0; seed < 400; ++seed) {
        std::vector<Photon> photons;
        for (std::size_t i = 0; i < 1000; ++i) {
            RandomSequence random(seed, RandomStream::photons, 0, i);
            const glm::vec2 at = random.next2();
            const FaceId face = at.y <= at.x ? 0 : 1;
            photons.push_back({{at, 0}, Rgb(0.001f), {0, 0, 1}, face, 0});
        }
        const ChosenMaps maps = build_chosen_maps(photons, surfaces, {50}, {MapMode::global});
        for (std::size_t i = 0; i < points.size(); ++i) {
            const FaceId face = points[i].y <= points[i].x ? 0 : 1;
            means[i].add(
                estimate_irradiance(maps, surfaces, {{points[i], 0}, {0, 0, 1}, face, 0}, scratch)
                    .y);
        }
    }
    CHECK(std::abs(means[0].z_score(1)) < kMostZ);
    for (std::size_t i = 0; i < points.size(); ++i)
        CHECK(means[i].mean() == Approx(truth[i]).epsilon(0.05));
}
