#include "common/math/sampling.h"
#include "render/paths/direct_light.h"
#include "tests/support/form_factor.h"
#include "tests/support/statistics.h"
#include "tests/support/tiny_rooms.h"

#include <catch2/catch.hpp>

using namespace hipmap;

namespace {

/// Irradiance by one sample, from the radiance that diffuse albedo 1/2 sends back.
double irradiance(const RenderScene& scene, const Interaction& at, std::uint64_t path,
                  int points = 1)
{
    RandomSequence random(17, RandomStream::eye_paths, 0, path);
    const LobeRays rays{.gathered = 1, .points = points};
    const Rgb light =
        light_sampled_light(scene, at, rays, random) + bsdf_sampled_light(scene, at, rays, random);
    return light.y * kPi / 0.5;
}

/// Irradiance at (x, 0, z) of the floor seen from above, over many samples.
RunningMean irradiance_at(const tiny::ReadyScene& ready, float x, float z, int samples,
                          int points = 1)
{
    Ray down;
    down.origin = {x, 0.05f, z};
    down.direction = {0, -1, 0};
    const std::optional<RayHit> hit = ready.render->rays.nearest(down);
    REQUIRE(hit);
    const Interaction at = interact(*ready.render, down, *hit);
    RunningMean mean;
    for (int i = 0; i < samples; ++i)
        mean.add(irradiance(*ready.render, at, static_cast<std::uint64_t>(i), points));
    return mean;
}

} // namespace

TEST_CASE("direct light: a point light by the inverse square and the cosine", "[integrator]")
{
    Scene scene = tiny::diffuse_floor();
    ScenePointLight light;
    light.position = {0.1f, 0.4f, -0.2f};
    light.intensity = Rgb(3);
    scene.lights = {light};
    const auto ready = tiny::ready(scene);
    for (const float x : {-0.4f, 0.0f, 0.3f}) {
        const double distance2 = (x - 0.1) * (x - 0.1) + 0.4 * 0.4 + 0.2 * 0.2;
        const double truth = 3 * 0.4 / std::pow(distance2, 1.5);
        CHECK(irradiance_at(*ready, x, 0, 2).mean() == Approx(truth).epsilon(1e-5));
    }
}

TEST_CASE("direct light: a sun by the cosine, a spot by its cone", "[integrator]")
{
    Scene scene = tiny::diffuse_floor();
    SceneSunLight sun;
    sun.direction = glm::normalize(glm::vec3(1, -2, 0));
    sun.irradiance = Rgb(5);
    scene.lights = {sun};
    CHECK(irradiance_at(*tiny::ready(scene), 0.2f, 0.1f, 2).mean() ==
          Approx(5 * 2 / std::sqrt(5.0)));

    SceneSpotLight spot;
    spot.position = {0, 0.5f, 0};
    spot.direction = {0, -1, 0};
    spot.intensity = Rgb(2);
    spot.cos_inner = std::cos(0.2f);
    spot.cos_outer = std::cos(0.5f);
    scene.lights = {spot};
    const auto ready = tiny::ready(scene);
    CHECK(irradiance_at(*ready, 0.05f, 0, 2).mean() ==
          Approx(2 * 0.5 / std::pow(0.05 * 0.05 + 0.25, 1.5)).epsilon(1e-5));
    CHECK(irradiance_at(*ready, 0.45f, 0, 2).mean() == 0);
}

TEST_CASE("direct light: a square light by its form factor", "[integrator]")
{
    Scene scene = tiny::diffuse_floor();
    tiny::add(scene, tiny::floor_at(0.3f, -0.4f), tiny::emissive(Rgb(2)));
    const auto ready = tiny::ready(scene);
    // Straight below the middle: four rectangles of half the side.
    const RunningMean middle = irradiance_at(*ready, 0, 0, 20000);
    CHECK(std::abs(middle.z_score(2 * 4 * corner_rectangle(0.2, 0.2, 0.3))) < kMostZ);
    // Below a point 0.1 beyond the side: differences of rectangles.
    const RunningMean beyond = irradiance_at(*ready, 0.3f, 0, 20000);
    const double truth =
        2 * 2 * (corner_rectangle(0.5, 0.2, 0.3) - corner_rectangle(0.1, 0.2, 0.3));
    CHECK(std::abs(beyond.z_score(truth)) < kMostZ);
}

TEST_CASE("direct light: a light that nearly touches the surface stays steady", "[integrator]")
{
    Scene scene = tiny::diffuse_floor();
    tiny::add(scene, tiny::floor_at(0.001f, -0.4f), tiny::emissive(Rgb(1)));
    const auto ready = tiny::ready(scene);
    Ray down;
    down.origin = {0.03f, 0.0005f, 0.02f};
    down.direction = {0, -1, 0};
    const Interaction at = interact(*ready->render, down, *ready->render->rays.nearest(down));
    RunningMean mean;
    double largest = 0;
    for (std::uint64_t i = 0; i < 20000; ++i) {
        const double value = irradiance(*ready->render, at, i);
        largest = std::max(largest, value);
        mean.add(value);
    }
    CHECK(std::abs(mean.z_score(kPi * (1 - 1e-4))) < kMostZ);
    CHECK(largest <
          3 * kPi); // both techniques together are bounded by twice the truth and a little
}

TEST_CASE("direct light: under a uniform sky an open floor receives pi L", "[integrator]")
{
    Scene scene = tiny::diffuse_floor();
    scene.environment = Rgb(0.25f);
    const auto ready = tiny::ready(scene);
    const RunningMean mean = irradiance_at(*ready, 0, 0, 100);
    CHECK(mean.mean() == Approx(kPi * 0.25).epsilon(1e-4));
}

TEST_CASE("direct light: many lights are sampled without bias", "[integrator]")
{
    Scene scene = tiny::diffuse_floor();
    double truth = 0;
    for (int i = 0; i < 100; ++i) {
        ScenePointLight light;
        light.position = {0.01f * static_cast<float>(i) - 0.5f, 0.3f, 0.1f};
        light.intensity = Rgb(static_cast<float>(i % 7));
        const double distance2 = glm::dot(glm::dvec3(light.position), glm::dvec3(light.position));
        truth += (i % 7) * 0.3 / std::pow(distance2, 1.5);
        scene.lights.push_back(light);
    }
    const RunningMean mean = irradiance_at(*tiny::ready(scene), 0, 0, 5000);
    CHECK(std::abs(mean.z_score(truth)) < kMostZ);
}

TEST_CASE("direct light: many emissive meshes are sampled without bias", "[integrator]")
{
    // Panels to all sides of the point; those that face away or lie below the floor give nothing.
    Scene scene = tiny::diffuse_floor();
    double truth = 0;
    RandomSequence random(9, RandomStream::pictures, 0, 0);
    for (int i = 0; i < 60; ++i) {
        const glm::vec3 middle(random.next() - 0.5f, 0.5f * random.next() - 0.1f,
                               random.next() - 0.5f);
        if (std::abs(middle.y) < 0.06f)
            continue;
        const glm::vec3 normal = sample_sphere(random.next2());
        const glm::vec3 u = 0.05f * glm::normalize(glm::cross(normal, glm::vec3(0.3f, 1, 0.2f)));
        const glm::vec3 v = glm::cross(normal, u);
        const std::vector<glm::dvec3> corners{middle, middle + u, middle + u + v, middle + v};
        const auto radiance = static_cast<float>(1 + i % 5);
        tiny::add(scene, tiny::parallelogram(middle, u, v), tiny::emissive(Rgb(radiance)));
        if (glm::dot(normal, middle) < 0 && middle.y > 0)
            truth += radiance * polygon_irradiance(glm::dvec3(0), {0, 1, 0}, corners);
    }
    const auto ready = tiny::ready(scene);
    const RunningMean one = irradiance_at(*ready, 0, 0, 20'000);
    CHECK(std::abs(one.z_score(truth)) < kMostZ);
    for (const int points : {2, 4, 7}) {
        const RunningMean several = irradiance_at(*ready, 0, 0, 20'000, points);
        CHECK(std::abs(several.z_score(truth)) < kMostZ);
        // Of as many samples: they are stratified.
        CHECK(several.standard_error() < 1.05 * one.standard_error() / std::sqrt(points));
    }
}
