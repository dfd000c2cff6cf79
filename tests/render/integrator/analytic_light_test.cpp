#include "render/integrator/path_tracer.h"
#include "render/paths/direct_light.h"
#include "render/shading/scatter.h"
#include "tests/support/means_of_images.h"
#include "tests/support/render_image.h"
#include "tests/support/statistics.h"
#include "tests/support/tiny_rooms.h"

#include <catch2/catch.hpp>

using namespace hipmap;

namespace {

/// A ball, a ball that is a spot, a sun, a sheared rectangle and an ellipse over the floor.
Scene with_light(Scene scene, int kind)
{
    const glm::vec3 position(0.1f, 0.25f, 0.05f), intensity(1, 2, 3);
    const glm::vec3 direction = glm::normalize(glm::vec3(-0.2f, -1, 0.1f));
    const ScenePointLight ball{
        .name = "", .position = position, .intensity = intensity, .radius = 0.1f};
    const SceneSpotLight spot{.name = "",
                              .position = position,
                              .direction = direction,
                              .intensity = intensity,
                              .cos_inner = std::cos(0.4f),
                              .cos_outer = std::cos(0.8f),
                              .radius = 0.1f};
    const SceneSunLight sun{
        .name = "", .direction = direction, .irradiance = intensity, .half_angle = 0.3f};
    SceneAreaLight area;
    area.centre = position;
    area.half_right = {0.15f, 0, 0};
    area.half_up = {0.03f, 0.02f, -0.1f};
    area.direction = -glm::normalize(glm::cross(area.half_right, area.half_up));
    area.is_disc = kind == 4;
    area.radiance = {4, 3, 2};
    const SceneLight lights[] = {ball, spot, sun, area, area};
    scene.lights = {lights[kind]};
    return scene;
}

/// Twenty dim lights more, so that a tree chooses.
Scene among_many(Scene scene)
{
    for (int i = 0; i < 20; ++i) {
        ScenePointLight light;
        light.position = {0.1f * static_cast<float>(i) - 1, 3, 0};
        light.intensity = Rgb(1e-6f);
        light.radius = i % 2 == 0 ? 0.01f : 0.0f;
        scene.lights.push_back(light);
    }
    return scene;
}

Interaction on_floor(const RenderScene& scene)
{
    Ray ray;
    ray.origin = {-0.3f, 0.2f, 0};
    ray.direction = glm::normalize(-ray.origin);
    return interact(scene, ray, *scene.rays.nearest(ray));
}

/// Light that one ray of the lobes finds; `weighed` leaves out the share of the light samples.
Rgb found_by(const RenderScene& scene, const Interaction& at, Lobes lobes, bool weighed,
             RandomSequence& random)
{
    const ScatterSample sample = sample_scatter(at, lobes, random);
    if (is_black(sample.weight))
        return Rgb(0);
    const Ray ray = scattered_ray(at, sample);
    const RaySource source = weighed ? source_at(at, sample.pdf) : RaySource{};
    return sample.weight *
           met_lights(scene, ray, distance_of(scene.rays.nearest(ray)), Rgb(0), source);
}

} // namespace

TEST_CASE("analytic lights: samples and rays that run into them together are rays alone",
          "[integrator]")
{
    const int kind = GENERATE(0, 1, 2, 3, 4);
    const bool many = GENERATE(false, true);
    Scene scene = tiny::diffuse_floor();
    scene.materials[0].specular = 1;
    scene.materials[0].roughness = 0.25f;
    scene = with_light(scene, kind);
    if (many)
        scene = among_many(scene);
    const auto ready = tiny::ready(scene);
    const Interaction at = on_floor(*ready->render);
    RunningMean together, alone;
    for (std::uint64_t i = 0; i < 40'000; ++i) {
        RandomSequence random(29, RandomStream::eye_paths, 0, i);
        Rgb both = light_sampled_light(*ready->render, at, {1, 1}, random), lobes(0.0f);
        for (const Lobes kinds : {Lobes::gathered, Lobes::followed}) {
            both += found_by(*ready->render, at, kinds, true, random);
            lobes += found_by(*ready->render, at, kinds, false, random);
        }
        together.add(both.y);
        alone.add(lobes.y);
    }
    INFO("kind " << kind << ": " << together.mean() << " and " << alone.mean());
    CHECK(std::abs(together.mean() - alone.mean()) <
          kMostZ * std::hypot(together.standard_error(), alone.standard_error()));
    CHECK(alone.standard_error() < 0.03 * alone.mean());
    CHECK(together.standard_error() < alone.standard_error());
}

TEST_CASE("analytic lights: the eye does not see them, a mirror shows them", "[integrator]")
{
    Scene scene = tiny::diffuse_floor();
    scene.materials[0] = tiny::mirror(Rgb(1));
    const auto ready = tiny::ready(with_light(scene, 0));
    RandomSequence random(7, RandomStream::eye_paths, 0, 0);
    Ray up;
    up.origin = {0.1f, 0.05f, 0.05f};
    up.direction = {0, 1, 0};
    CHECK(is_black(trace_path(*ready->render, up, random)));
    Ray down = up;
    down.origin.y = 0.1f;
    down.direction = {0, -1, 0};
    const double radiance = 2 / (kPi * 0.01);
    CHECK(trace_path(*ready->render, down, random).y == Approx(radiance).epsilon(1e-4));
}

TEST_CASE(
    "analytic lights: the integrators agree on a room with a glass ball, lit by analytic lights",
    "[integrator]")
{
    const int kind = GENERATE(0, 4);
    Scene scene = with_light(
        tiny::with_glass_and_mirror(tiny::box(tiny::diffuse({0.7f, 0.6f, 0.5f})), Rgb(0.9f)), kind);
    const auto ready = tiny::ready(scene);
    ImageOptions options;
    options.width = options.height = 16;
    options.photons = 10'000;
    check_agreement(*ready, options, 8, 40, {.most_noise = 0.02});
}
