#include "render/integrator/integrators.h"
#include "render/integrator/progressive.h"
#include "tests/support/statistics.h"
#include "tests/support/tiny_rooms.h"

#include <catch2/catch.hpp>

using namespace hipmap;

namespace {

RenderOptions small_options(Integrator integrator, const LightClasses& light)
{
    RenderOptions options;
    options.integrator = integrator;
    options.light = light;
    options.width = options.height = 16;
    options.photons = 8000;
    options.dissertation.mode = MapMode::shared;
    return options;
}

struct Rendered {
    RunningMean radiance, narrowest;
    RenderStatistics statistics;
};

Rendered render(const tiny::ReadyScene& ready, const RenderOptions& options, std::uint64_t passes)
{
    Rendered out;
    const PassSource source = make_pass_source(*ready.render, options, out.statistics);
    for (std::uint64_t pass = 0; pass < passes; ++pass) {
        const RenderedPass rendered = source.render(pass, {});
        out.radiance.add(mean_of(rendered.images.radiance));
        if (source.bias == BiasKnowledge::from_radii)
            out.narrowest.add(mean_of(rendered.images.narrower));
    }
    return out;
}

constexpr LightClasses kSubsets[] = {{true, false}, {false, true}, {false, false}};

/// A floor lit only through a box of clear glass around a light, seen from above.
Scene light_in_glass()
{
    Scene scene = tiny::diffuse_floor();
    TriangleMesh box = tiny::cube();
    tiny::scale(box, 0.2f);
    tiny::move(box, {0, 0.2f, 0});
    tiny::add(scene, box, tiny::glass(1.5f));
    ScenePointLight light;
    light.position = {0, 0.2f, 0};
    light.intensity = Rgb(1);
    scene.lights.push_back(light);
    scene.cameras[0].position = {0.3f, 0.4f, 0.3f};
    scene.cameras[0].forward = {0, -1, 0};
    scene.cameras[0].right = {1, 0, 0};
    scene.cameras[0].up = {0, 0, -1};
    scene.cameras[0].tan_half_height = 0.2f;
    return scene;
}

} // namespace

TEST_CASE("light classes: each subset is the same light to photons and to paths", "[integrator]")
{
    const auto ready = tiny::ready(tiny::room());
    double least = 1e9;
    for (const LightClasses& light : kSubsets) {
        RenderOptions options = small_options(Integrator::progressive, light);
        options.samples = 8;
        const Rendered gathered = render(*ready, options, 16);
        options.integrator = Integrator::path;
        options.samples = 30;
        const Rendered paths = render(*ready, options, 16);
        INFO("caustic " << light.caustic << ", indirect " << light.indirect);
        // Bias that goes with the radius itself is halved in the narrowest; else it is less.
        const double bias = 2 * std::abs(gathered.radiance.mean() - gathered.narrowest.mean());
        const double noise =
            std::hypot(gathered.radiance.standard_error(), paths.radiance.standard_error());
        CHECK(std::abs(gathered.radiance.mean() - paths.radiance.mean()) < bias + kMostZ * noise);
        CHECK(bias + kMostZ * noise < 0.04 * paths.radiance.mean());
        least = std::min(least, paths.radiance.mean());
    }
    // The classes add something, or the tests above would show nothing.
    const Rendered all = render(*ready, small_options(Integrator::progressive, {}), 4);
    CHECK(all.radiance.mean() > 1.2 * least);
}

TEST_CASE("light classes: light that comes by glass alone is gone without caustics", "[integrator]")
{
    const auto ready = tiny::ready(light_in_glass());
    for (const Integrator integrator : {Integrator::direct, Integrator::progressive}) {
        const auto mean = [&](bool caustic) {
            RenderOptions options = small_options(integrator, {caustic, true});
            options.photons = 1000; // a third of them never leave the glass
            return render(*ready, options, 2).radiance.mean();
        };
        CHECK(mean(true) > 0);
        CHECK(mean(false) == 0);
    }
}

TEST_CASE("light classes: without bounces an emissive box shows its emission and one reflection",
          "[integrator]")
{
    const auto ready = tiny::ready(tiny::furnace());
    for (const Integrator integrator :
         {Integrator::direct, Integrator::progressive, Integrator::path}) {
        RenderOptions options = small_options(integrator, {true, false});
        options.samples = 4;
        CHECK(std::abs(render(*ready, options, 8).radiance.z_score(0.75)) < kMostZ);
    }
}

TEST_CASE("light classes: what is left out is neither traced nor stored", "[integrator]")
{
    const auto ready = tiny::ready(tiny::room());
    for (const Integrator integrator : {Integrator::direct, Integrator::progressive}) {
        const auto done = [&](const LightClasses& light) {
            return render(*ready, small_options(integrator, light), 1).statistics;
        };
        const RenderStatistics all = done({true, true});
        CHECK(all.caustic.stored > 0);
        CHECK(all.global.stored > 0);
        const RenderStatistics no_caustics = done({false, true});
        CHECK(no_caustics.aimed == 0);
        CHECK(no_caustics.caustic.stored == 0);
        CHECK(no_caustics.global.stored > 0);
        CHECK(no_caustics.caustic.searches.queries == 0);
        const RenderStatistics no_bounces = done({true, false});
        CHECK(no_bounces.emitted == 0);
        CHECK(no_bounces.caustic.stored == all.caustic.stored);
        CHECK(no_bounces.global.stored + no_bounces.indirect.stored == 0);
        CHECK(no_bounces.global.searches.queries + no_bounces.indirect.searches.queries == 0);
        const RenderStatistics none = done({false, false});
        CHECK(none.emitted + none.aimed == 0);
    }
}

TEST_CASE("light classes: photons that are kept are the same whatever else is left out",
          "[integrator]")
{
    const auto ready = tiny::ready(tiny::room());
    PhotonOptions options{5000, 1, 0, false, 1000};
    const TracedPhotons all = trace_photons(*ready->render, options);
    options.light = {true, false};
    const TracedPhotons caustic = trace_photons(*ready->render, options);
    REQUIRE(caustic.caustic.size() == all.caustic.size());
    REQUIRE(!all.caustic.empty());
    for (std::size_t i = 0; i < all.caustic.size(); ++i)
        CHECK(caustic.caustic[i].position == all.caustic[i].position);
    CHECK(caustic.global.empty());
    options.light = {false, true};
    const TracedPhotons indirect = trace_photons(*ready->render, options);
    CHECK(indirect.caustic.empty());
    CHECK(indirect.global.size() < all.global.size()); // those that went on from a caustic are gone
    const glm::dvec3 sum = indirect.power.absorbed + indirect.power.escaped;
    CHECK(sum.y == Approx(indirect.power.emitted.y).epsilon(0.05));
}
