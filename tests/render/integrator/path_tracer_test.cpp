#include "tests/support/means_of_images.h"
#include "tests/support/render_image.h"
#include "tests/support/statistics.h"
#include "tests/support/tiny_rooms.h"

#include <catch2/catch.hpp>

using namespace hipmap;

TEST_CASE("path tracer and photon maps agree on a room with glass and mirror", "[integrator]")
{
    const auto ready = tiny::ready(tiny::room());
    ImageOptions options;
    options.width = 24;
    options.height = 16;
    options.photons = 50000;
    const auto [maps, paths, noise] =
        by_maps_and_paths(*ready, options, 16, 100, Integrator::direct);
    // Estimates blur across faceted balls and close corners, which leaves a bias below 1 part in
    // 100.
    CHECK(std::abs(maps.mean() - paths.mean()) < 0.01 * paths.mean() + kMostZ * noise);
    CHECK(noise < 0.01 * paths.mean());
}
