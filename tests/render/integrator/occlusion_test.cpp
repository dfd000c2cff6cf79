#include "render/integrator/occlusion.h"
#include "tests/support/render_image.h"
#include "tests/support/tiny_rooms.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using namespace hipmap;

namespace {

/// Form factor from a point to a parallel square centred above it (Howell's catalogue, B-3).
double square_above(double side, double height)
{
    const double x = side / 2 / height;
    return 4 / std::numbers::pi * x / std::sqrt(1 + x * x) * std::atan(x / std::sqrt(1 + x * x));
}

/// A floor of side 1 seen from just above its middle, and a small roof over the camera.
Scene under_roof(float side, float height)
{
    Scene scene = tiny::diffuse_floor();
    tiny::add(scene, tiny::floor_at(height, side), tiny::diffuse(Rgb(0)));
    Camera& camera = scene.cameras[0];
    camera.position = {0, 0.02f, 0};
    camera.forward = {0, -1, 0};
    camera.right = {1, 0, 0};
    camera.up = {0, 0, -1};
    camera.tan_half_height = 0.01f;
    return scene;
}

double mean_occlusion(const Scene& scene, double distance = 0)
{
    const auto ready = tiny::ready(scene);
    ImageOptions options;
    options.integrator = Integrator::occlusion;
    options.occlusion_distance = distance;
    options.width = options.height = 16;
    options.samples = 64;
    return mean_of(render_image(*ready->render, options, {}).image);
}

} // namespace

TEST_CASE("occlusion: under a square roof it is one minus its form factor", "[integrator]")
{
    CHECK(mean_occlusion(under_roof(0.2f, 0.1f)) ==
          Approx(1 - square_above(0.2, 0.1)).margin(0.02));
    CHECK(mean_occlusion(under_roof(0.2f, 0.5f)) == 1); // out of reach
    CHECK(mean_occlusion(under_roof(0.2f, 0.1f), 0.05) == 1);
    CHECK(mean_occlusion(under_roof(1, 0.5f), 5) == Approx(1 - square_above(1, 0.5)).margin(0.02));
}
