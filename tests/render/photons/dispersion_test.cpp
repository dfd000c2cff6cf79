#include "render/photons/trace_photons.h"
#include "render/shading/dispersion.h"
#include "tests/support/tiny_rooms.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace hipmap;

namespace {

constexpr float kSlope = 0.3f; ///< radians, of the lower side of the wedge

/// A wedge whose upper side is level: light from straight above is bent by the lower one alone.
TriangleMesh wedge()
{
    const float w = 0.1f, top = 0.3f, low = top - 2 * w * std::tan(kSlope);
    return tiny::make_mesh(
        {{-w, top, w}, {w, top, w}, {w, top, -w}, {-w, top, -w}, {w, low, w}, {w, low, -w}},
        {{0, 1, 2}, {0, 2, 3}, {0, 4, 1}, {3, 2, 5}, {1, 4, 5}, {1, 5, 2}, {0, 3, 5}, {0, 5, 4}});
}

} // namespace

TEST_CASE("dispersion: a wedge bends the light of each photon by the index of its colour",
          "[photons]")
{
    constexpr float kIndex = 1.5f, kDispersion = 1;
    Scene scene = tiny::diffuse_floor();
    Material glass = tiny::glass(kIndex);
    glass.dispersion = kDispersion;
    tiny::add(scene, wedge(), glass);
    SceneSunLight sun;
    sun.direction = {0, -1, 0};
    sun.irradiance = Rgb(1);
    scene.lights.push_back(sun);
    const auto ready = tiny::ready(scene);
    PhotonOptions options;
    options.paths = 10;
    options.caustic_paths = 20000;
    options.light.indirect = false;
    const TracedPhotons traced = trace_photons(*ready->render, options);

    const float most_blue = dispersed_index(kIndex, kDispersion, 380);
    const float least_red = dispersed_index(kIndex, kDispersion, 720);
    int red = 0, blue = 0, others = 0;
    for (const Photon& photon : traced.caustic) {
        const float bend = std::atan2(std::abs(photon.direction.x), photon.direction.y);
        const float index = std::sin(kSlope + bend) / std::sin(kSlope);
        if (std::abs(photon.direction.z) > 1e-4f || index < least_red || index > most_blue) {
            ++others; // it was reflected on its way
            continue;
        }
        const Rgb& power = photon.power;
        if (power.x > 10 * std::max(power.y, power.z)) {
            ++red;
            CHECK(index < dispersed_index(kIndex, kDispersion, 580));
        }
        if (power.z > 10 * std::max(power.x, power.y)) {
            ++blue;
            CHECK(index > dispersed_index(kIndex, kDispersion, 500));
        }
    }
    CHECK(red > 200);
    CHECK(blue > 200);
    CHECK(10 * others < static_cast<int>(traced.caustic.size()));
}
