#include "experiments/rivals/radiosity.h"
#include "tests/experiments/rivals/rival_means.h"

#include <catch2/catch.hpp>

using namespace hipmap;

TEST_CASE("radiosity: a closed diffuse box has radiance one", "[rivals]")
{
    const auto ready = tiny::ready(tiny::emissive_box({0.3f, 0.5f, 0.7f}));
    RivalSettings settings = tiny::small_image(16);
    settings.cells = 200;
    settings.rays = 40'000;
    const RunningMean found = tiny::means_of_seeds(*ready, settings, render_radiosity);
    INFO(found.mean() << " with standard error " << found.standard_error());
    // Up to 0.1 % of the power stays unshot.
    CHECK(std::abs(found.mean() - 1) < 3 * found.standard_error() + 0.001);
    CHECK(found.standard_error() < 0.004);
}

TEST_CASE("radiosity: agrees with the path tracer on a point light", "[rivals]")
{
    const auto ready = tiny::ready(tiny::box_with_point_light());
    RivalSettings settings = tiny::small_image(16);
    settings.cells = 10'000;
    settings.rays = 60'000;
    const RunningMean found = tiny::means_of_seeds(*ready, settings, render_radiosity);
    const RunningMean paths = tiny::means_of_paths(*ready, settings, 100);
    INFO("found " << found.mean() << ", paths " << paths.mean());
    CHECK(std::abs(found.mean() / paths.mean() - 1) < 0.005);
}

TEST_CASE("radiosity: light that a mirror sends on is left out", "[rivals]")
{
    const auto ready = tiny::ready(tiny::room());
    RivalSettings settings = tiny::small_image(16);
    settings.cells = 2'000;
    settings.rays = 20'000;
    const RunningMean found = tiny::means_of_seeds(*ready, settings, render_radiosity);
    CHECK(found.mean() < 0.99 * tiny::means_of_paths(*ready, settings, 100).mean());
}
