#include "tests/support/mean_luminance.h"
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
    RunningMean maps, paths;
    for (options.seed = 0; options.seed < 12; ++options.seed) {
        options.integrator = Integrator::direct;
        options.samples = 16;
        maps.add(mean_luminance(render_image(*ready->render, options, {}).image));
        options.integrator = Integrator::path;
        options.samples = 100;
        paths.add(mean_luminance(render_image(*ready->render, options, {}).image));
    }
    // Estimates blur across faceted balls and close corners, which leaves a bias below 1 part in
    // 100.
    const double noise = std::hypot(maps.standard_error(), paths.standard_error());
    CHECK(std::abs(maps.mean() - paths.mean()) < 0.01 * paths.mean() + kMostZ * noise);
    CHECK(noise < 0.01 * paths.mean());
}
