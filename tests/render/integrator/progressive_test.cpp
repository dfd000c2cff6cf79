#include "render/integrator/integrators.h"
#include "render/integrator/progressive.h"
#include "tests/support/statistics.h"
#include "tests/support/tiny_rooms.h"

#include <catch2/catch.hpp>
#include <tbb/global_control.h>

using namespace hipmap;

namespace {

RenderOptions small_options(std::uint64_t photons)
{
    RenderOptions options;
    options.integrator = Integrator::progressive;
    options.width = options.height = 16;
    options.photons = photons;
    options.dissertation.mode = MapMode::shared;
    return options;
}

struct Means {
    RunningMean radiance, narrower;
};

Means mean_of_passes(const tiny::ReadyScene& ready, const RenderOptions& options,
                     std::uint64_t passes)
{
    RenderStatistics ignored;
    const PassSource source = make_pass_source(*ready.render, options, ignored);
    Means out;
    for (std::uint64_t pass = 0; pass < passes; ++pass) {
        const RenderedPass rendered = source.render(pass, {});
        out.radiance.add(mean_of(rendered.images.radiance));
        if (source.bias == BiasKnowledge::from_radii)
            out.narrower.add(mean_of(rendered.images.narrower));
    }
    return out;
}

/// Checks that images agree up to noise and the bias that narrower radii show, and that both are
/// less than a share of their mean.
void check_same_light(const Means& gathered, const Means& paths, double share)
{
    // Bias that goes with the radius itself is halved in the narrowest; else it is less.
    const double bias = 2 * std::abs(gathered.radiance.mean() - gathered.narrower.mean());
    const double noise =
        std::hypot(gathered.radiance.standard_error(), paths.radiance.standard_error());
    CAPTURE(gathered.radiance.mean(), paths.radiance.mean(), bias, noise);
    CHECK(std::abs(gathered.radiance.mean() - paths.radiance.mean()) < bias + kMostZ * noise);
    CHECK(bias + kMostZ * noise < share * paths.radiance.mean());
}

} // namespace

TEST_CASE("progressive: precomputed irradiance is right but for the photon it counts too often",
          "[integrator]")
{
    const auto ready = tiny::ready(tiny::emissive_box(Rgb(0.5f)));
    RenderOptions options = small_options(4000);
    options.dissertation.irradiance = GatheredIrradiance::precomputed;
    const RunningMean radiance = mean_of_passes(*ready, options, 48).radiance;
    const double bias = 1.0 / (options.maps.neighbours - 1);
    CHECK(std::abs(radiance.mean() - 1) < bias + kMostZ * radiance.standard_error());
    options.dissertation.irradiance = GatheredIrradiance::estimated;
    CHECK(radiance.mean() != mean_of_passes(*ready, options, 48).radiance.mean());
}

TEST_CASE("progressive: differs from paths by noise and by what narrower radii take away",
          "[integrator]")
{
    const auto ready = tiny::ready(tiny::room());
    RenderOptions options = small_options(20000);
    options.samples = 16;
    const Means gathered = mean_of_passes(*ready, options, 10);
    options.integrator = Integrator::path;
    options.samples = 60;
    check_same_light(gathered, mean_of_passes(*ready, options, 10), 0.04);
}

TEST_CASE("progressive: photons and rays share the light that a mirror sends to brushed metal",
          "[integrator]")
{
    Scene scene = tiny::box(tiny::diffuse(Rgb(0)));
    Material metal = tiny::mirror(Rgb(0.9f));
    metal.roughness = 0.28f;
    tiny::add(scene, tiny::floor_at(-0.4f, 0.4f), metal);
    tiny::add(scene, tiny::parallelogram({-0.3f, -0.35f, -0.45f}, {0.6f, 0, 0}, {0, 0.6f, 0}),
              tiny::mirror(Rgb(0.8f)));
    // Its light goes to the mirror alone.
    tiny::add(scene, tiny::parallelogram({0.05f, 0.2f, 0.1f}, {-0.1f, 0, 0}, {0, 0.1f, 0}),
              tiny::emissive(Rgb(20)));
    const auto ready = tiny::ready(std::move(scene));
    RenderOptions options = small_options(500'000);
    options.samples = 64;
    options.light.indirect = false;
    RenderStatistics statistics;
    make_pass_source(*ready->render, options, statistics).render(0, {});
    CHECK(statistics.glossy.stored > 0);
    CHECK(statistics.glossy.searches.photons_found > 0);
    const Means shared = mean_of_passes(*ready, options, 12);
    options.integrator = Integrator::path;
    options.samples = 700;
    check_same_light(shared, mean_of_passes(*ready, options, 12), 0.05);
}

TEST_CASE("progressive: at the foot of a box on a wide floor the light from the box is found",
          "[integrator]")
{
    Scene scene = tiny::make_scene(tiny::floor_at(-0.501f, 20));
    scene.materials[0] = tiny::diffuse(Rgb(0.7f));
    tiny::add(scene, tiny::cube(), tiny::diffuse({0.1f, 0.8f, 0.1f}));
    ScenePointLight lamp;
    lamp.position = {2, 2, 3};
    lamp.intensity = glm::dvec3(10);
    scene.lights.push_back(lamp);
    Camera& above = scene.cameras[0]; // sees the floor alone, from 2 % to 14 % of the box's side
    above.position = {0, 0.5f, 0.58f};
    above.forward = {0, -1, 0};
    above.up = {0, 0, -1};
    above.tan_half_height = 0.06f;
    const auto ready = tiny::ready(scene);
    RenderOptions options = small_options(20000);
    options.samples = 4;
    const Means gathered = mean_of_passes(*ready, options, 12);
    options.integrator = Integrator::path;
    options.samples = 64;
    const Means paths = mean_of_passes(*ready, options, 12);
    CHECK(gathered.radiance.mean() == Approx(paths.radiance.mean()).epsilon(0.03));
}

TEST_CASE("progressive: a pass has the same bits whenever and by however many threads",
          "[integrator]")
{
    const auto ready = tiny::ready(tiny::room());
    const RenderOptions options = small_options(5000);
    const auto fifth_pass = [&](std::size_t threads, bool others_before) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        RenderStatistics ignored;
        const PassSource source = make_pass_source(*ready->render, options, ignored);
        if (others_before)
            source.render(3, {});
        return source.render(5, {}).images;
    };
    const PassImages one = fifth_pass(1, false);
    CHECK(mean_of(one.radiance) > 0.1);
    for (const std::size_t threads : {2, 7}) {
        const PassImages many = fifth_pass(threads, true);
        CHECK(one.radiance.pixels == many.radiance.pixels);
        CHECK(one.narrow.pixels == many.narrow.pixels);
        CHECK(one.narrower.pixels == many.narrower.pixels);
        CHECK(one.kept == many.kept);
    }
}

TEST_CASE("progressive: without light all is black, without photons there is one bounce",
          "[integrator]")
{
    const Means dark = mean_of_passes(*tiny::ready(tiny::diffuse_floor()), small_options(1000), 2);
    CHECK(dark.radiance.mean() == 0);
    RenderOptions options = small_options(1000);
    options.dissertation.mode = MapMode::none;
    const Means bounce = mean_of_passes(*tiny::ready(tiny::emissive_box(Rgb(0.5f))), options, 16);
    CHECK(std::abs(bounce.radiance.z_score(0.75)) < kMostZ);
}
