#include "tests/support/render_image.h"
#include "tests/support/tiny_rooms.h"

#include <catch2/catch.hpp>

#include <optional>

using namespace hipmap;

namespace {

RenderOptions options_of(Integrator integrator)
{
    RenderOptions options;
    options.integrator = integrator;
    options.width = 64;
    options.height = 40;
    options.photons = 20000;
    options.samples = 4;
    return options;
}

std::optional<CoarseImage> coarse_image(const Scene& scene, const RenderOptions& options)
{
    const auto ready = tiny::ready(scene);
    std::optional<CoarseImage> out;
    int calls = 0;
    PilotControl pilots;
    pilots.coarse = [&](const CoarseImage& coarse) {
        out = coarse;
        ++calls;
    };
    RenderStatistics ignored;
    make_pass_source(*ready->render, options, ignored, nullptr, pilots);
    CHECK(calls == 1);
    return out;
}

} // namespace

TEST_CASE("coarse image: fills pixels linearly and leaves those that are kept", "[integrator]")
{
    CoarseImage ramp{Image(4, 3), 8, 0};
    const auto value = [](double x, double y) {
        return Rgb(static_cast<float>(x + 2 * y), static_cast<float>(x), 1.0f);
    };
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 4; ++x)
            ramp.image.at(x, y) = value(8 * x + 4, 8 * y + 4); // at the middle of the block
    Image image(30, 24);
    std::vector<std::uint8_t> kept(image.pixels.size(), 0);
    kept[30 * 5 + 6] = 1;
    image.at(6, 5) = Rgb(-1);
    fill_by_coarse(ramp, kept, image);
    for (int y = 4; y < 20; ++y)
        for (int x = 4; x < 28; ++x) {
            const Rgb expected = x == 6 && y == 5 ? Rgb(-1) : value(x + 0.5, y + 0.5);
            CHECK(glm::length(image.at(x, y) - expected) < 1e-4f);
        }
    CHECK(image.at(0, 0) == ramp.image.at(0, 0)); // beyond the middle of the outermost blocks
    CHECK(image.at(29, 23) == ramp.image.at(3, 2));
}

TEST_CASE("coarse image: has the radiance of the image by every integrator", "[integrator]")
{
    for (const Integrator integrator :
         {Integrator::progressive, Integrator::direct, Integrator::path}) {
        const auto coarse = coarse_image(tiny::furnace(), options_of(integrator));
        REQUIRE(coarse);
        CHECK(coarse->image.width == 8);
        CHECK(coarse->image.height == 5);
        CHECK(coarse->block == 8);
        CHECK(coarse->pass > 0);
        CHECK(mean_of(coarse->image) == Approx(1).margin(0.06));
    }
}

TEST_CASE("coarse image: is of the pixels to render and never large", "[integrator]")
{
    RenderOptions options = options_of(Integrator::occlusion);
    options.crop = {10, 5, 39, 16};
    const auto cropped = coarse_image(tiny::furnace(), options);
    REQUIRE(cropped);
    CHECK(cropped->image.width == 4); // blocks of 8 pixels
    CHECK(cropped->image.height == 2);
    options.crop = {};
    options.width = 7680;
    options.height = 100;
    CHECK(coarse_block(options) == 80);
}

TEST_CASE("coarse image: pilots that are stopped render no pass", "[integrator]")
{
    const auto ready = tiny::ready(tiny::room());
    const RenderOptions options = options_of(Integrator::progressive);
    std::atomic<bool> stop = true;
    RenderStatistics ignored;
    const PassSource source =
        make_pass_source(*ready->render, options, ignored, nullptr, {&stop, {}, {}});
    RenderState state = begin_state(source, {});
    RunControl control;
    control.stop = &stop;
    const RunResult result = run_passes(source, {}, control, state);
    CHECK(result.reason == StopReason::caller);
    CHECK(state.film.passes.ranges.empty());
    CHECK(result.image.pixels.size() == 64 * 40);
    CHECK(result.kept == std::vector<std::uint8_t>(64 * 40, 0));
}
