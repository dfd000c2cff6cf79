#include "common/math/frame.h"
#include "common/math/sampling.h"
#include "render/shading/emission.h"
#include "render/shading/lights.h"
#include "tests/support/statistics.h"
#include "tests/support/tiny_scenes.h"

#include <catch2/catch.hpp>

using namespace hipmap;

namespace {

PunctualLight spot_light()
{
    PunctualLight light;
    light.kind = LightKind::spot;
    light.intensity = {1, 2, 3};
    light.direction = glm::normalize(glm::vec3(1, 2, -2));
    light.cos_inner = std::cos(0.3f);
    light.cos_outer = std::cos(0.7f);
    return light;
}

Scene lit_floor()
{
    Scene scene = tiny::make_scene(tiny::floor_at(0, 1));
    scene.materials[0] = tiny::matt(Rgb(0.5f));
    return scene;
}

/// Mean and spread of the power that reaches a set of directions, per steradian.
RunningMean emitted_in_cone(const tiny::ReadyScene& ready, const glm::vec3& axis, float cos_edge,
                            std::uint64_t paths)
{
    const EmissionPlan plan = plan_emission(ready.render->lights, paths);
    RunningMean mean;
    for (std::uint64_t i = 0; i < plan.paths; ++i) {
        RandomSequence random(5, RandomStream::photons, 0, i);
        const EmittedPath path = emit_path(*ready.render, plan, i, random);
        const bool inside = glm::dot(path.ray.direction, axis) > cos_edge;
        mean.add(inside ? path.power.y * static_cast<double>(plan.paths) : 0.0);
    }
    return mean;
}

} // namespace

TEST_CASE("lights: a spot's power is the integral of its intensity", "[shading]")
{
    const PunctualLight light = spot_light();
    RunningMean mean;
    for (std::uint64_t i = 0; i < 200000; ++i) {
        RandomSequence random(1, RandomStream::photons, 0, i);
        mean.add(light_intensity(light, sample_sphere(random.next2())).y * 4 * kPi);
    }
    CHECK(std::abs(mean.z_score(light_power(light, 1).y)) < kMostZ);
}

TEST_CASE("emission: a spot's light paths follow its intensity", "[shading]")
{
    Scene scene = lit_floor();
    scene.lights = {spot_light()};
    const auto ready = tiny::ready(scene);
    for (const float angle : {0.2f, 0.3f, 0.45f, 0.6f, 0.68f}) {
        // Reference: numeric integral of the intensity over the cone.
        double truth = 0;
        const int n = 20000;
        const double height = (1 - std::cos(double{angle})) / n;
        for (int i = 0; i < n; ++i) {
            const float cosine = static_cast<float>(1 - (i + 0.5) * height);
            const glm::vec3 direction =
                Frame(scene.lights[0].direction).to_world(direction_from_cosine(cosine, 0.1f));
            truth += light_intensity(scene.lights[0], direction).y * 2 * kPi * height;
        }
        const RunningMean mean =
            emitted_in_cone(*ready, scene.lights[0].direction, std::cos(angle), 200000);
        CHECK(std::abs(mean.z_score(truth)) < kMostZ);
    }
}

TEST_CASE("emission: all paths together carry the power of the lights", "[shading]")
{
    Scene scene = lit_floor();
    tiny::add(scene, tiny::floor_at(0.5f, -0.3f), tiny::lamp({4, 5, 6}));
    scene.materials.back().double_sided = true;
    PunctualLight point;
    point.intensity = {1, 2, 3};
    point.position = {0, 0.2f, 0};
    PunctualLight sun;
    sun.kind = LightKind::directional;
    sun.intensity = {3, 2, 1};
    scene.lights = {point, spot_light(), sun};
    scene.environment = {0.1f, 0.2f, 0.3f};
    const auto ready = tiny::ready(scene);
    const LightSet& lights = ready->render->lights;

    const EmissionPlan plan = plan_emission(lights, 10000);
    glm::dvec3 sum(0);
    for (std::uint64_t i = 0; i < plan.paths; ++i) {
        RandomSequence random(5, RandomStream::photons, 0, i);
        sum += glm::dvec3(emit_path(*ready->render, plan, i, random).power);
    }
    glm::dvec3 truth(0);
    for (const PunctualLight& light : scene.lights)
        truth += glm::dvec3(light_power(light, lights.radius));
    truth += 2.0 * kPi * 0.09 * glm::dvec3(4, 5, 6);
    truth += 4.0 * kPi * kPi * lights.radius * lights.radius * glm::dvec3(scene.environment);
    for (int c = 0; c < 3; ++c)
        CHECK(sum[c] == Approx(truth[c]).epsilon(1e-4)); // every path of a light carries the same
}

TEST_CASE("emission: every light that shines has paths, a dark one has none", "[shading]")
{
    Scene scene = lit_floor();
    PunctualLight bright, faint, dark;
    bright.intensity = Rgb(1e6f);
    faint.intensity = Rgb(1e-6f);
    scene.lights = {bright, dark, faint};
    const auto ready = tiny::ready(scene);
    const EmissionPlan plan = plan_emission(ready->render->lights, 1000);
    const auto paths_of = [&](int i) { return plan.first_path[i + 1] - plan.first_path[i]; };
    CHECK(paths_of(0) >= 900);
    CHECK(paths_of(1) == 0);
    CHECK(paths_of(2) == 50); // its half of the floor share of a tenth
    CHECK(plan_emission(ready->render->lights, 0).paths == 0);
    scene.lights = {dark};
    CHECK(plan_emission(tiny::ready(scene)->render->lights, 1000).paths == 0);
}
