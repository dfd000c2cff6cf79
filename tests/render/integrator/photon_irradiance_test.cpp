#include "common/math/sampling.h"
#include "render/dissertation/dissertation.h"
#include "render/photons/trace_photons.h"
#include "tests/support/statistics.h"
#include "tests/support/tiny_rooms.h"

#include <catch2/catch.hpp>

#include <array>

using namespace hipmap;

namespace {

constexpr MapMode kModes[] = {MapMode::global, MapMode::shared, MapMode::thesis};

/// By mode, the mean of the estimates at the middle of the floor from direct photons, over
/// independent passes.
std::array<RunningMean, std::size(kModes)> estimated_irradiance(const tiny::ReadyScene& ready)
{
    const MapSurfaces surfaces(ready.scene.mesh, ready.partition);
    ChosenScratch scratch;
    std::array<RunningMean, std::size(kModes)> means;
    for (std::uint64_t pass = 0; pass < 100; ++pass) {
        const TracedPhotons traced = trace_photons(*ready.render, {20000, 3, pass, true});
        for (std::size_t i = 0; i < means.size(); ++i) {
            const ChosenMaps maps =
                build_chosen_maps(traced.global, surfaces, {50}, {kModes[i], 100});
            means[i].add(
                estimate_irradiance(maps, surfaces, {{0, 0, 0}, {0, 1, 0}, 0, 0}, scratch).y);
        }
    }
    return means;
}

/// The disc of the estimate is small against the light's height, but not nothing: second order in
/// radius over height, below 1 part in 100 here.
void check_against(const tiny::ReadyScene& ready, double truth)
{
    for (const RunningMean& mean : estimated_irradiance(ready)) {
        CHECK(std::abs(mean.mean() - truth) < 0.01 * truth + kMostZ * mean.standard_error());
        CHECK(mean.standard_error() < 0.02 * truth);
    }
}

} // namespace

TEST_CASE("photon irradiance: under a point light by the inverse square", "[integrator]")
{
    Scene scene = tiny::diffuse_floor();
    ScenePointLight light;
    light.position = {0, 0.5f, 0};
    light.intensity = Rgb(3);
    scene.lights = {light};
    check_against(*tiny::ready(scene), 3 / 0.25);
}

TEST_CASE("photon irradiance: under a square light by its form factor", "[integrator]")
{
    Scene scene = tiny::diffuse_floor();
    tiny::add(scene, tiny::floor_at(0.5f, -0.4f), tiny::emissive(Rgb(2)));
    // Four rectangles of half the side whose corners lie straight above the point; Howell's C-11.
    const double p = 0.2 / 0.5, u = std::sqrt(1 + p * p);
    check_against(*tiny::ready(scene), 2 * 4 * p / u * std::atan(p / u));
}
