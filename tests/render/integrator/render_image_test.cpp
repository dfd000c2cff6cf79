#include "common/math/sampling.h"
#include "tests/support/mean_luminance.h"
#include "tests/support/render_image.h"
#include "tests/support/statistics.h"
#include "tests/support/tiny_rooms.h"

#include <catch2/catch.hpp>
#include <tbb/global_control.h>

using namespace hipmap;

namespace {

ImageOptions small_options()
{
    ImageOptions options;
    options.width = 24;
    options.height = 16;
    options.photons = 20000;
    options.passes = 2;
    return options;
}

} // namespace

TEST_CASE("render: a closed diffuse sphere has radiance one in every mode with photons",
          "[integrator]")
{
    const auto ready = tiny::ready(tiny::furnace());
    for (const MapMode mode : {MapMode::global, MapMode::shared, MapMode::thesis})
        for (const DirectLight direct : {DirectLight::shadow_rays, DirectLight::photons}) {
            ImageOptions options = small_options();
            options.width = options.height = 16;
            options.dissertation.mode = mode;
            options.dissertation.local_min = 20;
            options.direct = direct;
            options.passes = 1;
            RunningMean mean;
            for (options.seed = 0; options.seed < 10; ++options.seed)
                mean.add(mean_luminance(render_image(*ready->render, options, {}).image));
            INFO("mode " << static_cast<int>(mode) << ", direct " << static_cast<int>(direct));
            // The facets of the sphere are chords: a disc around a point has a little more area on
            // the sphere than in the plane.  That bias is below 1 part in 200 here.
            CHECK(std::abs(mean.mean() - 1) < 0.005 + kMostZ * mean.standard_error());
            CHECK(mean.standard_error() < 0.005);
        }
}

TEST_CASE("render: without photons the sphere shows emission and one bounce", "[integrator]")
{
    const auto ready = tiny::ready(tiny::furnace());
    ImageOptions options = small_options();
    options.dissertation.mode = MapMode::none;
    options.samples = 16;
    RunningMean mean;
    for (options.seed = 0; options.seed < 16; ++options.seed)
        mean.add(mean_luminance(render_image(*ready->render, options, {}).image));
    CHECK(std::abs(mean.z_score(0.75)) < kMostZ);
}

TEST_CASE("render: 1, 2 and 7 threads make the same image, bit for bit", "[integrator]")
{
    const auto ready = tiny::ready(tiny::room());
    for (const MapMode mode : {MapMode::none, MapMode::global, MapMode::shared, MapMode::thesis,
                               MapMode::hierarchical}) {
        ImageOptions options = small_options();
        options.dissertation.mode = mode;
        options.dissertation.local_min = 100;
        const auto render_with = [&](std::size_t threads) {
            const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
            return render_image(*ready->render, options, {});
        };
        const RenderedImage one = render_with(1);
        CHECK(mean_luminance(one.image) > 0.1);
        for (const std::size_t threads : {2, 7}) {
            const RenderedImage many = render_with(threads);
            CHECK(one.image.pixels == many.image.pixels);
            CHECK(one.statistics.global.searches.photons_found ==
                  many.statistics.global.searches.photons_found);
            CHECK(one.statistics.global.level_searches.local.abandoned ==
                  many.statistics.global.level_searches.local.abandoned);
        }
    }
}

TEST_CASE("render: thesis and shared maps make the same image of a room of flat walls",
          "[integrator]")
{
    const auto ready = tiny::ready(tiny::room());
    ImageOptions options = small_options();
    options.dissertation.mode = MapMode::shared;
    const Image shared = render_image(*ready->render, options, {}).image;
    options.dissertation.mode = MapMode::thesis;
    options.dissertation.local_min = 100;
    const RenderedImage thesis = render_image(*ready->render, options, {});
    CHECK(thesis.statistics.global.levels.local_maps > 0);
    CHECK(thesis.statistics.global.level_searches.local.begun > 0);
    // The same photons, summed in another order.
    REQUIRE(thesis.image.pixels.size() == shared.pixels.size());
    for (std::size_t i = 0; i < shared.pixels.size(); ++i)
        CHECK(glm::all(glm::lessThanEqual(glm::abs(thesis.image.pixels[i] - shared.pixels[i]),
                                          1e-5f * shared.pixels[i])));
}

TEST_CASE("render: hierarchical and shared maps make the same image, bit for bit", "[integrator]")
{
    for (const bool furnace : {false, true})
        for (const LevelChoice levels : {LevelChoice::paying, LevelChoice::all}) {
            const auto ready = tiny::ready(furnace ? tiny::furnace() : tiny::room());
            ImageOptions options = small_options();
            options.dissertation.mode = MapMode::shared;
            options.maps.neighbours = 10;
            options.dissertation.local_min = 20;
            options.dissertation.levels = levels;
            const Image shared = render_image(*ready->render, options, {}).image;
            options.dissertation.mode = MapMode::hierarchical;
            const RenderedImage hierarchical = render_image(*ready->render, options, {});
            CHECK(hierarchical.image.pixels == shared.pixels);
            const KindStatistics& global = hierarchical.statistics.global;
            const std::uint64_t begun =
                global.level_searches.local.begun + global.level_searches.group.begun;
            CHECK((begun > 0) == (furnace && levels == LevelChoice::all));
        }
}

TEST_CASE("render: a mirror shows the sky by its reflectance, clear glass passes it whole",
          "[integrator]")
{
    const Integrator integrator = GENERATE(Integrator::direct, Integrator::path);
    for (const Material& material : {tiny::mirror(Rgb(0.8f)), tiny::glass(1.5f)}) {
        TriangleMesh ball = tiny::uv_sphere(32, 16);
        Scene scene = tiny::make_scene(ball);
        scene.materials[0] = material;
        scene.environment = Rgb(2);
        scene.cameras[0].position = {0, 0, 5};
        scene.cameras[0].tan_half_height = 0.1f;
        const auto ready = tiny::ready(scene);
        ImageOptions options = small_options();
        options.samples = 64;
        options.integrator = integrator;
        const Image image = render_image(*ready->render, options, {}).image;
        const bool clear = material.transmission > 0;
        for (const Rgb& pixel : image.pixels) {
            if (clear)
                CHECK(pixel.y == Approx(2.0).epsilon(0.05)); // light paths that bounce on are noise
            else
                CHECK(pixel.y == Approx(1.6).epsilon(0.02));
        }
    }
}

TEST_CASE("render: photons and shadow rays agree on direct light", "[integrator]")
{
    const auto ready = tiny::ready(tiny::room());
    ImageOptions options = small_options();
    options.width = options.height = 12;
    options.samples = 8;
    options.maps.neighbours = 30;
    RunningMean difference;
    for (options.seed = 0; options.seed < 10; ++options.seed) {
        options.direct = DirectLight::shadow_rays;
        const double rays = mean_luminance(render_image(*ready->render, options, {}).image);
        options.direct = DirectLight::photons;
        const double photons = mean_luminance(render_image(*ready->render, options, {}).image);
        difference.add(photons / rays);
    }
    // Photons blur shadows, which moves light about but hardly changes its amount.
    CHECK(std::abs(difference.mean() - 1) < 0.02 + kMostZ * difference.standard_error());
    CHECK(difference.standard_error() < 0.005);
}

TEST_CASE("render: a stop keeps whole passes", "[integrator]")
{
    const auto ready = tiny::ready(tiny::room());
    ImageOptions options = small_options();
    options.passes = 1;
    const Image one = render_image(*ready->render, options, {}).image;
    options.passes = 5;
    std::atomic<bool> stop{false};
    RenderControl control;
    control.stop = &stop;
    control.progress = [&stop](double done) { stop = stop || done > 0.3; }; // in the second pass
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
    const RenderedImage stopped = render_image(*ready->render, options, control);
    CHECK(stopped.stopped);
    CHECK(stopped.statistics.passes == 1);
    CHECK(stopped.image.pixels == one.pixels);
}
