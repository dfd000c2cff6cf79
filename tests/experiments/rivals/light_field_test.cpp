#include "common/input_error.h"
#include "experiments/rivals/light_field.h"
#include "tests/experiments/rivals/rival_means.h"

#include <catch2/catch.hpp>

using namespace hipmap;

TEST_CASE("light field: agrees with the path tracer on a wall at the depth of its plane",
          "[rivals]")
{
    const auto ready = tiny::ready(tiny::box_with_point_light());
    RivalSettings settings = tiny::small_image(8);
    settings.views = 2;
    settings.window = 0.01f;
    tiny::check_same(tiny::means_of_seeds(*ready, settings, render_light_field),
                     tiny::means_of_paths(*ready, settings, 100), 0.005);
}

TEST_CASE("light field: blurs what lies off its plane, the more the wider the window", "[rivals]")
{
    Scene scene = tiny::diffuse_floor();
    scene.lights.clear();
    tiny::add(scene, tiny::floor_at(0.1f, 0.02f), tiny::emissive(Rgb(3)));
    scene.cameras[0] = {};
    scene.cameras[0].position = {0, 0.5f, 0};
    scene.cameras[0].forward = {0, -1, 0};
    scene.cameras[0].up = {0, 0, -1};
    scene.cameras[0].tan_half_height = 0.1f;
    const auto ready = tiny::ready(std::move(scene));
    const auto brightest = [&](float window) {
        RivalSettings settings = tiny::small_image(8);
        settings.views = 2;
        settings.window = window;
        float most = 0;
        for (const Rgb& pixel : render_light_field(*ready->render, settings).image.pixels)
            most = std::max(most, pixel.x);
        return most;
    };
    CHECK(brightest(0.001f) == Approx(3).epsilon(0.01));
    CHECK(brightest(0.2f) < 1.6f);
}

TEST_CASE("light field: refuses a camera without perspective", "[rivals]")
{
    Scene scene = tiny::diffuse_floor();
    scene.cameras[0].projection = Projection::orthographic;
    const auto ready = tiny::ready(std::move(scene));
    CHECK_THROWS_AS(render_light_field(*ready->render, {}), InputError);
}
