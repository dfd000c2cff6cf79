#include "tests/support/means_of_images.h"
#include "tests/support/tiny_rooms.h"

#include <catch2/catch.hpp>

using namespace hipmap;

namespace {

/// With a ball of rough metal in the middle, to which nothing is lost.
Scene with_metal(Scene scene, const Rgb& color, float roughness)
{
    TriangleMesh ball = tiny::uv_sphere(32, 16);
    tiny::scale(ball, 0.25f);
    Material metal = tiny::mirror(color);
    metal.roughness = roughness;
    metal.energy_compensation = true;
    tiny::add(scene, ball, metal);
    return scene;
}

ImageOptions small_image()
{
    ImageOptions options;
    options.width = options.height = 16;
    options.photons = 10000;
    return options;
}

} // namespace

TEST_CASE("energy compensation: rough white metal cannot be seen where radiance is one all round",
          "[integrator]")
{
    // At roughness 0.3 facets lose 2 %, which are followed; at 0.9 half of all, gathered.
    for (const float roughness : {0.3f, 0.9f}) {
        const auto ready =
            tiny::ready(with_metal(tiny::emissive_box(Rgb(0.5f)), Rgb(1), roughness));
        ImageOptions options = small_image();
        for (const Integrator integrator :
             {Integrator::path, Integrator::direct, Integrator::progressive}) {
            options.integrator = integrator;
            const RunningMean mean = means_of(*ready, options, 6);
            // Maps close corners and blur across facets; the table of albedos is as near as that.
            const double bias = integrator == Integrator::path ? 0.003 : 0.01;
            INFO("roughness " << roughness << ", integrator " << static_cast<int>(integrator)
                              << ": " << mean.mean() << " +- " << mean.standard_error());
            CHECK(std::abs(mean.mean() - 1) < bias + kMostZ * mean.standard_error());
            CHECK(mean.standard_error() < 0.01);
        }
    }
}

TEST_CASE("energy compensation: photon maps agree with paths on coloured metal", "[integrator]")
{
    const auto ready = tiny::ready(with_metal(tiny::room(), {1, 0.7f, 0.3f}, 0.8f));
    check_agreement(*ready, small_image(), 16, 30);
}
