#include "render/integrator/indirect_choice.h"
#include "render/integrator/integrators.h"
#include "tests/support/statistics.h"
#include "tests/support/tiny_rooms.h"

#include <catch2/catch.hpp>

using namespace hipmap;

namespace {

RenderOptions small_options(IndirectLight indirect)
{
    RenderOptions options;
    options.integrator = Integrator::progressive;
    options.width = options.height = 16;
    options.photons = 10000;
    options.samples = 16;
    options.indirect = indirect;
    return options;
}

/// The room of glass and mirror, with a ball of brushed metal and a sheet of paper.
Scene room_of_all_lobes()
{
    Scene scene = tiny::room();
    TriangleMesh ball = tiny::uv_sphere(16, 8);
    tiny::scale(ball, 0.12f);
    tiny::move(ball, {0, -0.1f, -0.2f});
    Material metal = tiny::mirror(Rgb(0.9f));
    metal.roughness = 0.3f;
    tiny::add(scene, ball, metal);
    Material paper = tiny::diffuse({0.4f, 0.3f, 0.2f});
    paper.diffuse_transmission = 0.5f;
    paper.diffuse_transmission_color = Rgb(0.8f);
    tiny::add(scene, tiny::floor_at(0.2f, -0.25f), paper);
    return scene;
}

/// A ball on a floor below an even sky.
Scene ball_in_the_open()
{
    Scene scene = tiny::diffuse_floor();
    TriangleMesh ball = tiny::uv_sphere(16, 8);
    tiny::scale(ball, 0.2f);
    tiny::move(ball, {0, 0.2f, 0});
    tiny::add(scene, ball, tiny::diffuse(Rgb(0.7f)));
    scene.environment = Rgb(1);
    scene.cameras[0].position = {0, 0.3f, 1.2f};
    scene.cameras[0].tan_half_height = 0.5f;
    return scene;
}

struct Rendered {
    RunningMean radiance, narrowest;
    RenderStatistics statistics;
    PassSource source;
};

Rendered render(const tiny::ReadyScene& ready, const RenderOptions& options, std::uint64_t passes)
{
    Rendered out;
    out.source = make_pass_source(*ready.render, options, out.statistics);
    for (std::uint64_t pass = 0; pass < passes; ++pass) {
        const RenderedPass rendered = out.source.render(pass, {});
        out.radiance.add(mean_of(rendered.images.radiance));
        if (out.source.bias == BiasKnowledge::from_radii)
            out.narrowest.add(mean_of(rendered.images.narrower));
    }
    return out;
}

IndirectLight chosen(const Scene& scene, RenderOptions options)
{
    RenderStatistics statistics;
    return choose_indirect(*tiny::ready(scene)->render, options, {}, statistics);
}

} // namespace

TEST_CASE("indirect choice: light by paths is the light by photons and of the path tracer",
          "[integrator]")
{
    const auto ready = tiny::ready(room_of_all_lobes());
    RenderOptions options = small_options(IndirectLight::paths);
    const Rendered paths = render(*ready, options, 16);
    CHECK(paths.statistics.global.stored == 0);
    CHECK(paths.statistics.caustic.stored > 0);
    options.integrator = Integrator::path;
    options.samples = 30;
    const Rendered truth = render(*ready, options, 16);
    const double bias = 2 * std::abs(paths.radiance.mean() - paths.narrowest.mean());
    const double noise =
        std::hypot(paths.radiance.standard_error(), truth.radiance.standard_error());
    CHECK(std::abs(paths.radiance.mean() - truth.radiance.mean()) < bias + kMostZ * noise);
    CHECK(bias + kMostZ * noise < 0.03 * truth.radiance.mean());
}

TEST_CASE("indirect choice: in the open no photon is traced, and the image has no bias",
          "[integrator]")
{
    const auto ready = tiny::ready(ball_in_the_open());
    RenderOptions options = small_options(IndirectLight::automatic);
    const Rendered found = render(*ready, options, 16);
    CHECK(found.statistics.indirect_by == IndirectLight::paths);
    CHECK(found.statistics.emitted + found.statistics.aimed == 0);
    CHECK(found.source.photons == 0);
    CHECK(found.radiance.mean() == found.narrowest.mean());
    options.indirect = IndirectLight::photons;
    const Rendered photons = render(*ready, options, 16);
    CHECK(photons.statistics.emitted > 0);
    options.integrator = Integrator::path;
    const Rendered truth = render(*ready, options, 16);
    CHECK(std::abs(found.radiance.mean() - truth.radiance.mean()) <
          kMostZ * std::hypot(found.radiance.standard_error(), truth.radiance.standard_error()));
}

TEST_CASE("indirect choice: photons where paths would be noisy, or hardly find light",
          "[integrator]")
{
    const RenderOptions options = small_options(IndirectLight::automatic);
    CHECK(chosen(tiny::emissive_box(Rgb(0.9f)), options) == IndirectLight::photons);
    CHECK(chosen(tiny::box(tiny::diffuse(Rgb(0.7f))), options) == IndirectLight::photons);
}

TEST_CASE("indirect choice: is that of the whole image, whatever part of it is rendered",
          "[integrator]")
{
    for (const Scene& scene : {ball_in_the_open(), tiny::room()}) {
        RenderOptions options = small_options(IndirectLight::automatic);
        const IndirectLight whole = chosen(scene, options);
        options.crop = {0, 0, 3, 2};
        CHECK(chosen(scene, options) == whole);
    }
}
