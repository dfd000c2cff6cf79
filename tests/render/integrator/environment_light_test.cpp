#include "render/lights/emission.h"
#include "render/paths/direct_light.h"
#include "tests/support/means_of_images.h"
#include "tests/support/render_image.h"
#include "tests/support/statistics.h"
#include "tests/support/tiny_rooms.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace hipmap;

namespace {

/// A texture of a dim sky with a sun of 2 x 2 pixels, and the irradiance of a floor by it.
struct SunnySky {
    Image picture{64, 32};
    double irradiance = 0;
};

SunnySky sunny_sky(float sky, float sun)
{
    SunnySky out;
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 64; ++x) {
            const bool in_sun = (y == 7 || y == 8) && (x == 20 || x == 21);
            out.picture.at(x, y) = Rgb(in_sun ? sun : sky);
            // The integral of cosine over the pixel.
            const double upper = std::cos(M_PI * y / 32), lower = std::cos(M_PI * (y + 1) / 32);
            if (y < 16)
                out.irradiance += out.picture.at(x, y).y * (2 * M_PI / 64) * 0.5 *
                                  (upper * upper - lower * lower);
        }
    return out;
}

std::unique_ptr<tiny::ReadyScene> under(const Image& picture, Scene scene)
{
    auto out = tiny::ready(std::move(scene));
    out->render = std::make_unique<RenderScene>(out->scene, out->partition,
                                                make_environment_map(picture, 1, 0.4f));
    return out;
}

/// Anything: half of its cells are never drawn.
DirectionGuide any_guide()
{
    DirectionGuide out{.by_lobes = 0};
    RandomSequence random(3, RandomStream::pictures, 0, 0);
    float sum = 0;
    for (float& up_to : out.up_to)
        up_to = sum += std::max(0.0f, random.next() - 0.5f);
    for (float& up_to : out.up_to)
        up_to /= sum;
    return out;
}

/// sky: by which the sky has a sample; null: none.
RunningMean irradiance_of_floor(const tiny::ReadyScene& ready, int samples,
                                const DirectionGuide* sky = nullptr)
{
    Ray down;
    down.origin = {0, 0.05f, 0};
    down.direction = {0, -1, 0};
    const Interaction at = interact(*ready.render, down, *ready.render->rays.nearest(down));
    RunningMean mean;
    for (int i = 0; i < samples; ++i) {
        RandomSequence random(17, RandomStream::eye_paths, 0, static_cast<std::uint64_t>(i));
        const Rgb light =
            light_sampled_light(*ready.render, at, {.gathered = 1, .sky = sky}, random) +
            bsdf_sampled_light(*ready.render, at, {.gathered = 1, .sky = sky}, random);
        mean.add(light.y * M_PI / 0.5);
    }
    return mean;
}

} // namespace

TEST_CASE("sky light: an environment map of one radiance lights as the uniform sky does",
          "[integrator]")
{
    Image even(16, 8);
    for (Rgb& pixel : even.pixels)
        pixel = Rgb(0.25f);
    const RunningMean mean = irradiance_of_floor(*under(even, tiny::diffuse_floor()), 20'000);
    CHECK(std::abs(mean.z_score(M_PI * 0.25)) < kMostZ);
}

TEST_CASE("sky light: a small sun in an environment map lights by its cosine", "[integrator]")
{
    const SunnySky sky = sunny_sky(0.1f, 500);
    const RunningMean mean =
        irradiance_of_floor(*under(sky.picture, tiny::diffuse_floor()), 20'000);
    CHECK(std::abs(mean.z_score(sky.irradiance)) < kMostZ);
    CHECK(mean.standard_error() < 0.005 * sky.irradiance); // which rays of lobes alone are far from
}

TEST_CASE("sky light: it is the same whatever guides its samples", "[integrator]")
{
    const DirectionGuide guide = any_guide();
    const SunnySky sky = sunny_sky(0.1f, 500);
    const auto by_map = under(sky.picture, tiny::diffuse_floor());
    const RunningMean of_map = irradiance_of_floor(*by_map, 20'000, &guide);
    CHECK(std::abs(of_map.z_score(sky.irradiance)) < kMostZ);
    CHECK(of_map.standard_error() < 0.01 * sky.irradiance);
    Scene even = tiny::diffuse_floor();
    even.environment = Rgb(0.25f);
    const RunningMean of_even = irradiance_of_floor(*tiny::ready(even), 20'000, &guide);
    CHECK(std::abs(of_even.z_score(M_PI * 0.25)) < kMostZ);
    CHECK(of_even.standard_error() < 0.01 * M_PI * 0.25);
}

TEST_CASE("sky light: photons from an environment map carry its power", "[integrator]")
{
    const SunnySky sky = sunny_sky(0.1f, 500);
    const auto ready = under(sky.picture, tiny::diffuse_floor());
    const LightSet& lights = ready->render->lights;
    const EmissionPlan plan = plan_emission(lights, 40'000, Emitters::all);
    RunningMean power; // that comes down onto the floor
    for (std::uint64_t i = 0; i < plan.paths; ++i) {
        RandomSequence random(5, RandomStream::photons, 0, i);
        const EmittedPath path = emit_path(lights, share_of(plan, i), random);
        const bool down = path.ray.direction.y < 0 && ready->render->rays.nearest(path.ray);
        power.add(down ? path.power.y * static_cast<double>(plan.paths) : 0);
    }
    CHECK(std::abs(power.z_score(sky.irradiance)) < kMostZ); // the floor has area 1
}

TEST_CASE(
    "sky light: the integrators agree under an environment map, with a glass and a mirror ball",
    "[integrator]")
{
    const SunnySky sky = sunny_sky(0.5f, 100);
    const auto ready =
        under(sky.picture, tiny::with_glass_and_mirror(
                               [] {
                                   Scene scene = tiny::make_scene(tiny::floor_at(-0.45f, 2));
                                   scene.materials[0] = tiny::diffuse({0.7f, 0.6f, 0.5f});
                                   scene.cameras[0].position = {0, 0, 0.9f};
                                   scene.cameras[0].tan_half_height = 0.5f;
                                   return scene;
                               }(),
                               Rgb(0.9f)));
    ImageOptions options;
    options.width = options.height = 16;
    options.photons = 20'000;
    check_agreement(*ready, options, 8, 100, {.most_noise = 0.03});
}
