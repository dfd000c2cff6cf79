#include "experiments/rivals/illumination_map.h"
#include "tests/experiments/rivals/rival_means.h"

#include <catch2/catch.hpp>

using namespace hipmap;

TEST_CASE("illumination map: a closed diffuse box has radiance one", "[rivals]")
{
    const auto ready = tiny::ready(tiny::emissive_box({0.3f, 0.5f, 0.7f}));
    RivalSettings settings = tiny::small_image(32);
    settings.cells = 200;
    settings.rays = 20'000;
    const RunningMean found = tiny::means_of_seeds(*ready, settings, render_illumination_map);
    INFO(found.mean() << " with standard error " << found.standard_error());
    CHECK(std::abs(found.z_score(1)) < 3);
    CHECK(found.standard_error() < 0.004);
}

TEST_CASE("illumination map: agrees with the path tracer on a room with glass and mirror",
          "[rivals]")
{
    const auto ready = tiny::ready(tiny::room());
    RivalSettings settings = tiny::small_image(32);
    settings.cells = 20'000; // cells blur, and a mean over the image hides most of that
    settings.rays = 30'000;
    tiny::check_same(tiny::means_of_seeds(*ready, settings, render_illumination_map),
                     tiny::means_of_paths(*ready, settings, 200), 0.01);
}
