#include "render/integrator/expect_light.h"
#include "render/integrator/gather_path.h"
#include "render/integrator/integrators.h"
#include "render/integrator/light_sample_allocation.h"
#include "render/integrator/path_tracer.h"
#include "render/integrator/pixel_samples.h"
#include "tests/render/integrator/all_integrators.h"
#include "tests/support/statistics.h"
#include "tests/support/tiny_rooms.h"

#include <catch2/catch.hpp>

using namespace hipmap;

namespace {

constexpr int kSide = 32;

RenderOptions small_picture()
{
    RenderOptions options;
    options.width = options.height = kSide;
    return options;
}

/// A light, and a ball of glass and one of mirror, in a box that reflects nothing.
std::unique_ptr<tiny::ReadyScene> black_room()
{
    Scene scene = tiny::with_glass_and_mirror(tiny::box(tiny::diffuse(Rgb(0))), Rgb(0.9f));
    tiny::add(scene, tiny::parallelogram({-0.2f, -0.05f, -0.4f}, {0.4f, 0, 0}, {0, 0.4f, 0}),
              tiny::emissive(Rgb(5)));
    return tiny::ready(std::move(scene));
}

/// A light, and a floor of brushed metal and a wall of metal, which see each other, in such a box.
std::unique_ptr<tiny::ReadyScene> black_room_with_metal(float wall_roughness)
{
    Scene scene = tiny::box(tiny::diffuse(Rgb(0)));
    Material metal = tiny::mirror(Rgb(0.9f)), wall = metal;
    metal.roughness = 0.25f;
    wall.roughness = wall_roughness;
    tiny::add(scene, tiny::floor_at(-0.4f, 0.4f), metal);
    tiny::add(scene, tiny::parallelogram({-0.2f, -0.4f, -0.21f}, {0.4f, 0, 0}, {0, 0.3f, 0}), wall);
    tiny::add(scene, tiny::parallelogram({-0.2f, -0.05f, -0.4f}, {0.4f, 0, 0}, {0, 0.4f, 0}),
              tiny::emissive(Rgb(5)));
    return tiny::ready(std::move(scene));
}

constexpr float kSunAngle = 0.05f;

/// Two walls that face each other, 0.1 apart and 1 high.  height: of a sun nearly straight below
/// them (-1) or above them (1).
std::unique_ptr<tiny::ReadyScene> facing_walls(const Material& left, const Material& right,
                                               float height = -1)
{
    Scene scene =
        tiny::make_scene(tiny::parallelogram({-0.05f, -0.5f, 0.5f}, {0, 0, -1}, {0, 1, 0}));
    scene.materials[0] = left;
    tiny::add(scene, tiny::parallelogram({0.05f, -0.5f, -0.5f}, {0, 0, 1}, {0, 1, 0}), right);
    scene.lights = {SceneSunLight{.name = "",
                                  .direction = glm::normalize(glm::vec3(-0.2f, -height, 0)),
                                  .irradiance = Rgb(3),
                                  .half_angle = kSunAngle}};
    scene.cameras[0] =
        tiny::square_view({0, 0.5f, 0}, glm::normalize(glm::vec3(1, -1, 0)), 0.05f, 0.1f);
    return tiny::ready(std::move(scene));
}

/// The long paths of a ray between such walls that goes so far to the right while it goes down.
LongPaths long_paths(const RenderScene& scene, float slope)
{
    Ray ray;
    ray.origin = {0, 0.5f, 0};
    ray.direction = glm::normalize(glm::vec3(slope, -1, 0));
    const std::optional<FarLight> sun = far_light(scene.lights.lights.at(0));
    LongPaths sum;
    constexpr int kSamples = 400;
    for (int i = 0; i < kSamples; ++i) {
        RandomSequence random(5, RandomStream::seen_lights, 0, static_cast<std::uint64_t>(i));
        sum += trace_long_paths(scene, {&sun.value(), 1}, ray, random);
    }
    sum /= kSamples;
    return sum;
}

/// Radiance of a ray, summed over the channels, with the lights it sees and without.
using Traced = std::function<Rgb(const Ray&, SeenLights, RandomSequence&)>;

/// What the lights that are added make, less their own samples, over the picture.
RunningMean difference(const RenderScene& scene, const Traced& trace, double& left_over)
{
    const RenderOptions options = small_picture();
    const PictureJob job{scene, options, 0, {}};
    RunningMean mean;
    for (int i = 0; i < 8 * kSide * kSide; ++i) {
        const auto pixel = static_cast<std::uint64_t>(i);
        RandomSequence random(5, RandomStream::eye_paths, 0, pixel);
        const Ray ray = pixel_ray(job, i % kSide, i / kSide % kSide, random).ray;
        const Rgb with = trace(ray, SeenLights::added, random);
        const Rgb without = trace(ray, SeenLights::left_out, random);
        mean.add(with.x - without.x - trace_seen_lights(scene, ray, random).x);
        left_over += without.x;
    }
    return mean;
}

std::uint16_t samples_at(const std::vector<std::uint16_t>& lights, const glm::vec2& at)
{
    const auto x = static_cast<std::size_t>(at.x * kSide),
               y = static_cast<std::size_t>(at.y * kSide);
    return lights[y * kSide + x];
}

} // namespace

TEST_CASE("seen lights: all the light there is where nothing else reflects", "[integrator]")
{
    const int room = GENERATE(0, 1, 2);
    const auto ready = room == 0 ? black_room() : black_room_with_metal(room == 1 ? 0.25f : 0.0f);
    const MapSurfaces surfaces(ready->scene.mesh, ready->partition);
    const ChosenMaps none;
    EyeScratch eye;
    const PassMaps maps{*ready->render, surfaces, none, none};
    double left_over = 0;
    const RunningMean direct = difference(
        *ready->render,
        [&](const Ray& ray, SeenLights seen, RandomSequence& random) {
            return trace_eye_path(maps, ray, seen, random, eye);
        },
        left_over);
    CHECK(std::abs(direct.z_score(0)) < kMostZ);
    const RunningMean path = difference(
        *ready->render,
        [&](const Ray& ray, SeenLights seen, RandomSequence& random) {
            return trace_path(*ready->render, ray, random, {}, seen);
        },
        left_over);
    CHECK(std::abs(path.z_score(0)) < kMostZ);
    GatherScratch scratch;
    const FirstRadii radii;
    const GatherMaps gather{*ready->render, surfaces, none, none, none, radii};
    const RunningMean progressive = difference(
        *ready->render,
        [&](const Ray& ray, SeenLights seen, RandomSequence& random) {
            return trace_gather_path(gather, ray, seen, random, scratch)[0];
        },
        left_over);
    CHECK(std::abs(progressive.z_score(0)) < kMostZ);
    CHECK(left_over == 0);
}

TEST_CASE("seen lights: pixels at their edges take samples of their own", "[integrator]")
{
    Scene scene = tiny::box(tiny::diffuse(Rgb(0.5f)));
    const RenderOptions options = small_picture();
    const auto allocated = [&](const RenderScene& of) {
        return allocate_light_samples(measure_light_noise(of, options), options.samples);
    };
    CHECK(allocated(*tiny::ready(scene)->render).empty());
    // From 0.48 before it, the far wall reaches to 0.5/0.98 of what a half height of 0.8 shows.
    tiny::add(scene, tiny::parallelogram({-0.25f, -0.25f, -0.499f}, {0.5f, 0, 0}, {0, 0.5f, 0}),
              tiny::emissive(Rgb(5)));
    const auto ready = tiny::ready(scene);
    const auto lights = allocated(*ready->render);
    const float edge = 0.25f / 0.979f / 0.8f / 2;
    REQUIRE(lights.size() == kSide * kSide);
    for (const float side : {-1.0f, 1.0f}) {
        CHECK(samples_at(lights, {0.5f + side * edge, 0.5f}) > 0);
        CHECK(samples_at(lights, {0.5f, 0.5f + side * edge}) > 0);
        CHECK(samples_at(lights, {0.5f + side * edge / 2, 0.5f}) == 0); // the light alone
        CHECK(samples_at(lights, {0.5f + side * 1.5f * edge, 0.5f}) == 0);
    }
    CHECK(lights == allocated(*ready->render));
}

TEST_CASE("seen lights: long paths find a sun as if all directions around it were alike",
          "[integrator]")
{
    Material smooth = tiny::mirror(Rgb(1)), rough = smooth;
    rough.roughness = 0.2f;
    const double irradiance = 3, sine = std::sin(kSunAngle / 2);
    const double angle = 4 * M_PI * sine * sine;
    const auto mirrors = facing_walls(smooth, smooth);
    const LongPaths ten = long_paths(*mirrors->render, 1);
    CHECK(ten.surfaces == 10);
    CHECK(ten.mean == Approx(irradiance / M_PI).epsilon(1e-4));
    CHECK(ten.variance == Approx(irradiance * irradiance / angle / M_PI).epsilon(0.01));
    const LongPaths five = long_paths(*mirrors->render, 0.5f);
    CHECK(five.surfaces == 5);
    CHECK(five.variance == 0);
    CHECK(long_paths(*facing_walls(smooth, smooth, 1)->render, 1).variance == 0); // behind it
    // Two surfaces are enough where a followed lobe sent the path on, last or before the last.
    CHECK(long_paths(*facing_walls(rough, rough)->render, 0.5f).variance > 0);
    CHECK(long_paths(*facing_walls(smooth, rough)->render, 0.5f).variance > 0);
}

TEST_CASE("seen lights: pixels with long paths take samples though none has found the sun",
          "[integrator]")
{
    const auto mirrors = facing_walls(tiny::mirror(Rgb(1)), tiny::mirror(Rgb(1)));
    const RenderOptions options = small_picture();
    const LightNoise noise = measure_light_noise(*mirrors->render, options);
    REQUIRE(noise.long_paths.size() == kSide * kSide);
    CHECK(std::ranges::all_of(noise.mean, [](float mean) { return mean == 0; }));
    const Image black(kSide / 2, kSide / 2);
    const SampleAllocation allocation =
        allocate_samples({black, black, noise, nullptr}, kSide, kSide, 4);
    CHECK(allocation.lights.empty()); // no brightness to compare with
    Image grey = black;
    std::ranges::fill(grey.pixels, Rgb(0.1f));
    const SampleAllocation seen = allocate_samples({grey, grey, noise, nullptr}, kSide, kSide, 4);
    REQUIRE(seen.lights.size() == kSide * kSide);
    CHECK(samples_at(seen.lights, {0.5f, 0.5f}) > 0);
}

TEST_CASE("seen lights: what a sample in a thousand finds is expected", "[integrator]")
{
    const float mean = 0.5f, share = 1e-3f;
    LightNoise noise;
    noise.mean.assign(kSide * kSide, mean);
    noise.variance.assign(kSide * kSide, mean * mean / share);
    Image grey(kSide / 2, kSide / 2);
    std::ranges::fill(grey.pixels, Rgb(0.1f));
    const PilotNoise pilot{grey, grey, noise};
    RenderOptions options = small_picture();
    options.samples = 4;
    options.filter = PixelFilter::box;
    const auto sum_of = [&](const SampleAllocation& allocation) {
        RareLight sum;
        for (const RareLight& light : expect_light(pilot, options, allocation).light) {
            sum.variance += light.variance;
            sum.missing += light.missing;
            sum.finds += light.finds;
        }
        return sum;
    };
    const double missing = mean * mean / (0.6 * 0.6 * 1.01); // brightness 0.6
    const RareLight evenly = sum_of({});
    CHECK(evenly.missing == Approx(missing));
    CHECK(evenly.variance == Approx(missing / share / 4));
    CHECK(evenly.finds == Approx(4 * share * kSide * kSide));
    SampleAllocation more;
    more.lights.assign(kSide * kSide, 64);
    CHECK(sum_of(more).finds == Approx(16 * evenly.finds));
    CHECK(sum_of(more).variance == Approx(evenly.variance / 16));
    options.filter = PixelFilter::b_spline;
    CHECK(sum_of({}).variance == Approx(0.3025 * evenly.variance));
    noise.variance.assign(kSide * kSide, 0);
    CHECK(expect_light(pilot, options, {}) == ExpectedLight());
}

TEST_CASE("seen lights: every integrator expects the light of long paths", "[integrator]")
{
    Material glowing = tiny::mirror(Rgb(1));
    glowing.emission = Rgb(0.1f);
    RenderOptions options = small_picture();
    RenderStatistics ignored;
    for (const float height : {-1.0f, 1.0f}) {
        const auto walls = facing_walls(tiny::mirror(Rgb(1)), glowing, height);
        for (const Integrator integrator : kAllIntegrators) {
            options.integrator = integrator;
            const PassSource source = make_pass_source(*walls->render, options, ignored);
            INFO("integrator " << int(integrator) << ", height of the sun " << height);
            CHECK((missing_square(source.expected, 4) > 0.01) == (height < 0));
        }
    }
}
