#include "common/input_error.h"
#include "experiments/rivals/bidirectional.h"
#include "tests/experiments/rivals/rival_means.h"

#include <catch2/catch.hpp>

using namespace hipmap;

namespace {

void check_against_paths(Scene scene, int paths, double most_noise)
{
    const auto ready = tiny::ready(std::move(scene));
    const RivalSettings settings = tiny::small_image(16);
    tiny::check_same(tiny::means_of_seeds(*ready, settings, render_bidirectional),
                     tiny::means_of_paths(*ready, settings, paths), most_noise);
}

} // namespace

TEST_CASE("bidirectional: a closed diffuse box has radiance one", "[rivals]")
{
    const auto ready = tiny::ready(tiny::emissive_box({0.3f, 0.5f, 0.7f}));
    const RunningMean found =
        tiny::means_of_seeds(*ready, tiny::small_image(16), render_bidirectional);
    INFO(found.mean() << " with standard error " << found.standard_error());
    CHECK(std::abs(found.z_score(1)) < 3);
    CHECK(found.standard_error() < 0.003);
}

TEST_CASE("bidirectional: agrees with the path tracer on a room with glass and mirror", "[rivals]")
{
    check_against_paths(tiny::room(), 150, 0.015);
}

TEST_CASE("bidirectional: agrees with the path tracer on a point light", "[rivals]")
{
    check_against_paths(tiny::box_with_point_light(), 100, 0.005);
}

TEST_CASE("bidirectional: agrees with the path tracer on a glossy metal", "[rivals]")
{
    Scene scene = tiny::room();
    Material metal = tiny::mirror(Rgb(0.8f));
    metal.roughness = 0.3f;
    tiny::add(scene, tiny::floor_at(-0.49f, 0.8f), metal);
    check_against_paths(std::move(scene), 150, 0.015);
}

TEST_CASE("bidirectional: sees caustics of a point light, which no path from the eye finds",
          "[rivals]")
{
    const auto ready =
        tiny::ready(tiny::with_glass_and_mirror(tiny::box_with_point_light(), Rgb(0.9f)));
    const RivalSettings settings = tiny::small_image(8);
    const RunningMean both = tiny::means_of_seeds(*ready, settings, render_bidirectional);
    const RunningMean paths = tiny::means_of_paths(*ready, settings, 50);
    CHECK(both.mean() > 1.02 * paths.mean());
}

TEST_CASE("bidirectional: refuses lights that it does not know", "[rivals]")
{
    Scene scene = tiny::diffuse_floor();
    scene.environment = Rgb(1);
    const auto ready = tiny::ready(std::move(scene));
    CHECK_THROWS_AS(render_bidirectional(*ready->render, {}), InputError);
}
