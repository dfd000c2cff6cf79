#include "render/integrator/integrators.h"
#include "tests/render/integrator/all_integrators.h"
#include "tests/support/mean_luminance.h"
#include "tests/support/mirror_shaft.h"
#include "tests/support/render_image.h"
#include "tests/support/statistics.h"
#include "tests/support/tiny_rooms.h"

#include <catch2/catch.hpp>

using namespace hipmap;

namespace {

struct Effort {
    int size = 12; ///< pixels a side
    std::uint64_t passes = 16;
    std::uint32_t samples = 4;
    std::uint64_t photons = 4000;
};

/// Mean of the channels of small pictures, by passes that do not depend on each other.
RunningMean measure(const Scene& scene, Integrator integrator, const Effort& effort)
{
    const auto ready = tiny::ready(scene);
    RenderOptions options;
    options.integrator = integrator;
    options.width = options.height = effort.size;
    options.photons = effort.photons;
    options.samples = effort.samples;
    RenderStatistics ignored;
    const PassSource source = make_pass_source(*ready->render, options, ignored);
    RunningMean out;
    for (std::uint64_t pass = 0; pass < effort.passes; ++pass)
        out.add(mean_of(source.render(pass, {}).images.radiance));
    return out;
}

/// By every integrator: `expected`, but for probability and a bias of 1 part in 200.
void check_mean(const Scene& scene, double expected, const Effort& effort)
{
    for (const Integrator integrator : kAllIntegrators) {
        const RunningMean found = measure(scene, integrator, effort);
        INFO("integrator " << int(integrator) << ": " << found.mean() << " +- "
                           << found.standard_error() << ", expected " << expected);
        CHECK(std::abs(found.mean() - expected) <
              0.005 * expected + kMostZ * found.standard_error());
        CHECK(found.standard_error() < 0.04 * expected);
    }
}

Scene with_ball(Scene room, float radius, const Material& material)
{
    TriangleMesh ball = tiny::uv_sphere(24, 12);
    tiny::scale(ball, radius);
    tiny::add(room, ball, material);
    return room;
}

} // namespace

TEST_CASE("long paths: a closed diffuse box of albedo 0.999", "[integrator]")
{
    check_mean(tiny::emissive_box(Rgb(0.999f)), 1, {12, 16, 1, 250});
}

TEST_CASE("long paths: a ball of glass in a furnace is not seen", "[integrator]")
{
    for (const float index : {1.5f, 4.0f, 10.0f})
        check_mean(with_ball(tiny::emissive_box(Rgb(0.5f)), 0.3f, tiny::glass(index)), 1,
                   {12, 8, 2, 4000});
}

TEST_CASE("long paths: glass in water in a furnace is not seen", "[integrator]")
{
    Scene scene = with_ball(with_ball(tiny::emissive_box(Rgb(0.5f)), 0.3f, tiny::glass(1.33f)),
                            0.2f, tiny::glass(1.5f));
    scene.nested_dielectrics = true;
    check_mean(scene, 1, {12, 12, 2, 4000});
}

TEST_CASE("long paths: down a corridor of mirrors", "[integrator]")
{
    for (const int bounces : {20, 1000}) {
        const tiny::MirrorShaft shaft{.bounces = bounces,
                                      .width = 1.0f,
                                      .base_color = Rgb(1 - 1 / static_cast<float>(bounces))};
        Scene scene = shaft.scene();
        tiny::add(scene, tiny::floor_at(-shaft.height() - 0.5f, 4), tiny::emissive(Rgb(1)));
        scene.cameras[0] = tiny::square_view({0.5f, 0.0f, 0}, shaft.entering(), 1e-4f, 1);
        check_mean(scene, shaft.passed(), {6, 8, 7, 100});
    }
}
