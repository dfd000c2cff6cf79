#include "render/integrator/picture_tiles.h"
#include "tests/support/tiny_rooms.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

using namespace hipmap;

namespace {

/// Not square, and of whole tiles on neither axis.
constexpr int kWidth = 35, kHeight = 18;

struct NoScratch {};

RenderOptions picture(PixelFilter filter, std::uint32_t samples)
{
    RenderOptions options;
    options.width = kWidth;
    options.height = kHeight;
    options.samples = samples;
    options.filter = filter;
    return options;
}

/// A bright sky over a floor.
std::unique_ptr<tiny::ReadyScene> bright_scene()
{
    Scene scene = tiny::diffuse_floor();
    scene.environment = Rgb(3);
    return tiny::ready(std::move(scene));
}

/// Something of a ray that varies from pixel to pixel, and for some rays is no number.
Rgb value_of(const Ray& ray)
{
    const float x = ray.direction.x, y = ray.direction.y;
    if (std::abs(x - 0.1f) < 0.02f)
        return Rgb(std::numeric_limits<float>::quiet_NaN());
    return {1 + x, std::exp(3 * y), 2 + std::sin(40 * x * y)};
}

template <typename Trace>
RenderedPass render(const PictureJob& job, RenderStatistics& statistics, const Trace& trace)
{
    const TileTracer tracer{trace, [](const auto&, const NoScratch&) {}, [](const NoScratch&) {}};
    return render_tiles<1, NoScratch>(job, {}, statistics, tracer);
}

/// docs/error.md (17)
double spline(double x)
{
    x = std::abs(x);
    return x <= 0.5 ? 0.75 - x * x : x <= 1.5 ? (1.5 - x) * (1.5 - x) / 2 : 0;
}

/// The sums of (17) over all samples of the picture, one pixel at a time.
glm::dvec3 brute_force(const PictureJob& job, int x, int y)
{
    glm::dvec3 sum(0);
    double weights = 0;
    for (int v = 0; v < kHeight; ++v)
        for (int u = 0; u < kWidth; ++u) {
            const auto pixel = static_cast<std::uint64_t>(v * kWidth + u);
            const std::uint32_t samples = job.samples(pixel);
            for (std::uint32_t s = 0; s < samples; ++s) {
                RandomSequence random =
                    sample_sequence(job, RandomStream::eye_paths, pixel, samples, s);
                const PixelRay from = pixel_ray(job, u, v, random);
                const Rgb value = value_of(from.ray);
                const double weight =
                    spline(u + from.at.x - x - 0.5) * spline(v + from.at.y - y - 0.5) / samples;
                if (!is_finite(value))
                    continue;
                sum += weight * glm::dvec3(value);
                weights += weight;
            }
        }
    return sum / weights;
}

} // namespace

TEST_CASE("pixel filter: weights have the moments of a B-spline", "[filter]")
{
    for (int i = 0; i <= 64; ++i) {
        const float at = static_cast<float>(i) / 64;
        // Three weights have no more than these three: they are the only ones.
        const auto w = filter_weights(PixelFilter::b_spline, at);
        CHECK(w[0] + w[1] + w[2] == Approx(1));
        CHECK(w[0] * -0.5f + w[1] * 0.5f + w[2] * 1.5f == Approx(at).margin(1e-6));
        float variance = 0;
        for (int k = 0; k < 3; ++k)
            variance +=
                w[static_cast<std::size_t>(k)] * std::pow(static_cast<float>(k) - 0.5f - at, 2.0f);
        CHECK(variance == Approx(0.25));
        CHECK(filter_weights(PixelFilter::box, at) == std::array<float, 3>{0, 1, 0});
    }
}

TEST_CASE("pixel filter: a pixel is the weighted mean of the samples around it", "[filter]")
{
    const auto ready = bright_scene();
    const RenderOptions options = picture(PixelFilter::b_spline, 3);
    SampleAllocation uneven;
    for (int i = 0; i < kWidth * kHeight; ++i)
        uneven.samples.push_back(static_cast<std::uint16_t>(1 + i % 5));
    const PictureJob job{*ready->render, options, 2, uneven};
    RenderStatistics statistics;
    const RenderedPass pass =
        render(job, statistics, [](const Ray& ray, SeenLights, RandomSequence&, NoScratch&) {
            return Samples<1>{value_of(ray)};
        });
    CHECK(statistics.dropped_samples > 0);
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const glm::dvec3 expected = brute_force(job, x, y);
            CAPTURE(x, y);
            REQUIRE(pass.images.kept[static_cast<std::size_t>(y * kWidth + x)] == 1);
            for (int c = 0; c < 3; ++c)
                CHECK(pass.images.radiance.at(x, y)[c] == Approx(expected[c]).epsilon(1e-5));
        }
}

TEST_CASE("pixel filter: a pixel is black and not kept where no sample around is finite",
          "[filter]")
{
    const auto ready = bright_scene();
    for (const PixelFilter filter : {PixelFilter::box, PixelFilter::b_spline}) {
        const RenderOptions options = picture(filter, 1);
        const SampleAllocation evenly;
        RenderStatistics statistics;
        const RenderedPass pass =
            render({*ready->render, options, 0, evenly}, statistics,
                   [](const Ray&, SeenLights, RandomSequence&, NoScratch&) {
                       return Samples<1>{Rgb(std::numeric_limits<float>::infinity())};
                   });
        CHECK(statistics.dropped_samples == kWidth * kHeight);
        CHECK(pass.images.kept == std::vector<std::uint8_t>(kWidth * kHeight, 0));
        for (const Rgb& pixel : pass.images.radiance.pixels)
            CHECK(pixel == Rgb(0));
    }
}

TEST_CASE("pixel filter: an even light is even, whether it has samples of its own or not",
          "[filter]")
{
    Scene scene = tiny::diffuse_floor();
    scene.environment = Rgb(3);
    Camera& camera = scene.cameras[0]; // sees the sky alone
    camera.position = {0, 0.5f, 0};
    camera.forward = {0, 1, 0};
    camera.up = {0, 0, 1};
    const auto ready = tiny::ready(std::move(scene));
    const RenderOptions options = picture(PixelFilter::b_spline, 1);
    SampleAllocation allocation;
    for (int i = 0; i < kWidth * kHeight; ++i)
        allocation.lights.push_back(i % 3 == 0 ? 16 : 0);
    RenderStatistics statistics;
    const RenderedPass pass =
        render({*ready->render, options, 0, allocation}, statistics,
               [](const Ray&, SeenLights seen, RandomSequence&, NoScratch&) {
                   return Samples<1>{seen == SeenLights::added ? Rgb(3) : Rgb(0)};
               });
    for (const Rgb& pixel : pass.images.radiance.pixels)
        CHECK(pixel.x == Approx(3).epsilon(1e-5));
}

TEST_CASE("clamp_samples: hues stay, the rest of the first is what was cut", "[integrator]")
{
    const Samples<3> samples = {Rgb(8, 4, 2), Rgb(1, 3, 2), Rgb(4, 4, 1)};
    const Samples<4> clamped = clamp_samples<3>(samples, 4);
    CHECK(clamped[0] == Rgb(4, 2, 1));
    CHECK(clamped[1] == samples[1]);
    CHECK(clamped[2] == samples[2]);
    CHECK(clamped[3] == Rgb(4, 2, 1));
    CHECK(clamp_samples<1>({Rgb(0)}, 1)[0] == Rgb(0));
}
