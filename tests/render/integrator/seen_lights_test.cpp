#include "render/integrator/gather_path.h"
#include "render/integrator/light_sample_allocation.h"
#include "render/integrator/path_tracer.h"
#include "render/integrator/pixel_samples.h"
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

/// A light, and a floor and a wall of brushed metal, which see each other, in such a box.
std::unique_ptr<tiny::ReadyScene> black_room_with_metal()
{
    Scene scene = tiny::box(tiny::diffuse(Rgb(0)));
    Material metal = tiny::mirror(Rgb(0.9f));
    metal.roughness = 0.25f;
    tiny::add(scene, tiny::floor_at(-0.4f, 0.4f), metal);
    tiny::add(scene, tiny::parallelogram({-0.2f, -0.4f, -0.21f}, {0.4f, 0, 0}, {0, 0.3f, 0}),
              metal);
    tiny::add(scene, tiny::parallelogram({-0.2f, -0.05f, -0.4f}, {0.4f, 0, 0}, {0, 0.4f, 0}),
              tiny::emissive(Rgb(5)));
    return tiny::ready(std::move(scene));
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
    const bool metal = GENERATE(false, true);
    const auto ready = metal ? black_room_with_metal() : black_room();
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
