#include "tests/support/means_of_images.h"
#include "tests/support/tiny_rooms.h"

#include <catch2/catch.hpp>

using namespace hipmap;

namespace {

/// With a ball of velvet in the middle.
Scene with_velvet(Scene scene, const Rgb& base, const Rgb& sheen)
{
    TriangleMesh ball = tiny::uv_sphere(32, 16);
    tiny::scale(ball, 0.25f);
    Material velvet = tiny::diffuse(base);
    velvet.sheen_color = sheen;
    velvet.sheen_roughness = 0.3f;
    tiny::add(scene, ball, velvet);
    return scene;
}

} // namespace

TEST_CASE("sheen light: white velvet cannot be seen where radiance is one all round",
          "[integrator]")
{
    const auto ready = tiny::ready(with_velvet(tiny::emissive_box(Rgb(0.5f)), Rgb(1), Rgb(1)));
    CHECK(ready->render->directional);
    ImageOptions options;
    options.width = options.height = 16;
    options.photons = 10000;
    for (const Integrator integrator :
         {Integrator::path, Integrator::direct, Integrator::progressive}) {
        options.integrator = integrator;
        const RunningMean mean = means_of(*ready, options, 16);
        // Maps close corners and blur across facets; the tables of albedo are as near as that.
        const double bias = integrator == Integrator::path ? 0.003 : 0.01;
        INFO("integrator " << static_cast<int>(integrator) << ": " << mean.mean() << " +- "
                           << mean.standard_error());
        CHECK(std::abs(mean.mean() - 1) < bias + kMostZ * mean.standard_error());
        CHECK(mean.standard_error() < 0.01);
    }
}

TEST_CASE("sheen light: photon maps agree with paths on coloured velvet", "[integrator]")
{
    const auto ready = tiny::ready(with_velvet(tiny::room(), {0.1f, 0.05f, 0.2f}, {1, 0.7f, 0.4f}));
    ImageOptions options;
    options.width = options.height = 16;
    options.photons = 10000;
    check_agreement(*ready, options, 8, 40);
}
