#include "common/math/sampling.h"
#include "render/paths/direct_light.h"
#include "tests/support/means_of_images.h"
#include "tests/support/tiny_rooms.h"

#include <catch2/catch.hpp>

using namespace hipmap;

namespace {

Material paper(const Rgb& reflected, const Rgb& passed)
{
    Material out = tiny::diffuse(reflected);
    out.diffuse_transmission = 0.6f;
    out.diffuse_transmission_color = passed;
    return out;
}

/// With a sheet across its middle, and a hollow ball.
Scene with_paper(Scene scene, const Material& material)
{
    tiny::add(scene, tiny::floor_at(0.05f, 0.7f), material);
    TriangleMesh ball = tiny::uv_sphere(24, 12);
    tiny::scale(ball, 0.14f);
    tiny::move(ball, {0, -0.2f, 0});
    tiny::add(scene, ball, material);
    return scene;
}

ImageOptions small_image(Integrator integrator)
{
    ImageOptions options;
    options.width = options.height = 16;
    options.photons = 10000;
    options.integrator = integrator;
    return options;
}

} // namespace

TEST_CASE("paper light: white paper cannot be seen where radiance is one all round", "[integrator]")
{
    const auto ready =
        tiny::ready(with_paper(tiny::emissive_box(Rgb(0.5f)), paper(Rgb(1), Rgb(1))));
    for (const Integrator integrator :
         {Integrator::path, Integrator::direct, Integrator::progressive}) {
        const RunningMean mean = means_of(*ready, small_image(integrator), 6);
        // Maps blur across facets and edges.
        const double bias = integrator == Integrator::path ? 0 : 0.012;
        INFO("integrator " << static_cast<int>(integrator) << ": " << mean.mean() << " +- "
                           << mean.standard_error());
        CHECK(std::abs(mean.mean() - 1) < bias + kMostZ * mean.standard_error());
        CHECK(mean.standard_error() < 0.01);
    }
}

TEST_CASE("paper light: the integrators agree below a sheet, where all light comes through it",
          "[integrator]")
{
    Material coated = paper({0.7f, 0.6f, 0.5f}, {0.9f, 0.8f, 0.3f});
    for (const float roughness : {1.0f, 0.5f}) { // plain sums, and photons weighed by direction
        coated.specular = roughness < 1 ? 1.0f : 0.0f;
        coated.roughness = roughness;
        Scene scene = tiny::box(tiny::diffuse({0.7f, 0.6f, 0.5f}));
        tiny::add(scene, tiny::floor_at(0.05f, 0.98f), coated); // all but a gap at the walls
        tiny::add(scene, tiny::floor_at(0.45f, -0.3f), tiny::emissive(Rgb(15)));
        scene.cameras[0].position = {0, -0.25f, 0.48f};
        const auto ready = tiny::ready(scene);
        CHECK(ready->render->directional == (roughness < 1));
        const RunningMean paths = means_of(*ready, small_image(Integrator::path), 20);
        for (const Integrator integrator : {Integrator::direct, Integrator::progressive}) {
            const RunningMean maps = means_of(*ready, small_image(integrator), 6);
            const double noise = std::hypot(maps.standard_error(), paths.standard_error());
            const double bias = integrator == Integrator::direct ? 0.03 : 0.015;
            INFO("integrator " << static_cast<int>(integrator) << ", roughness " << roughness
                               << ": maps " << maps.mean() << ", paths " << paths.mean()
                               << ", noise " << noise);
            CHECK(std::abs(maps.mean() - paths.mean()) < bias * paths.mean() + kMostZ * noise);
            CHECK(noise < 0.01 * paths.mean());
        }
    }
}

TEST_CASE("paper light: a light below a sheet lights what is seen of it from above", "[integrator]")
{
    Scene scene = tiny::make_scene(tiny::floor_at(0, 1));
    scene.materials[0] = paper(Rgb(0.5f), {0.9f, 0.8f, 0.3f});
    ScenePointLight light;
    light.position = {0, -0.3f, 0};
    light.intensity = Rgb(2);
    scene.lights.push_back(light);
    const auto ready = tiny::ready(scene);
    Ray ray;
    ray.origin = {0.2f, 0.5f, 0};
    ray.direction = {0, -1, 0};
    const Interaction at = interact(*ready->render, ray, ready->render->rays.nearest(ray).value());
    RandomSequence random(1, RandomStream::eye_paths, 0, 0);
    const Rgb seen = light_sampled_light(*ready->render, at, {.gathered = 1}, random);
    const double square = 0.3 * 0.3 + 0.2 * 0.2;
    const double irradiance = 2 * 0.3 / std::pow(square, 1.5);
    CHECK(seen.y == Approx(irradiance * 0.6 * 0.8 / kPi).epsilon(1e-4));
    CHECK(seen.z == Approx(irradiance * 0.6 * 0.3 / kPi).epsilon(1e-4));
}
