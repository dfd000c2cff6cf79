#include "common/math/sampling.h"
#include "render/integrator/path_tracer.h"
#include "render/lobes/glossy_albedo.h"
#include "render/paths/direct_light.h"
#include "render/shading/scatter.h"
#include "tests/support/means_of_images.h"
#include "tests/support/render_image.h"
#include "tests/support/statistics.h"
#include "tests/support/tiny_rooms.h"

#include <catch2/catch.hpp>

using namespace hipmap;

namespace {

Material glossy(Material material, float roughness, float specular = 1)
{
    material.roughness = roughness;
    material.specular = specular;
    return material;
}

Interaction seen_along(const RenderScene& scene, const Ray& ray)
{
    return interact(scene, ray, *scene.rays.nearest(ray));
}

/// From (-0.3, 0.2, 0) to the middle of the floor.
Ray aslant()
{
    Ray ray;
    ray.origin = {-0.3f, 0.2f, 0};
    ray.direction = glm::normalize(-ray.origin);
    return ray;
}

/// Light that one ray of the lobes finds; `weighed` leaves out the share of the light samples.
Rgb found_on_gloss(const RenderScene& scene, const Interaction& at, Lobes lobes, bool weighed,
                   RandomSequence& random)
{
    const ScatterSample sample = sample_scatter(at, lobes, random);
    if (is_black(sample.weight))
        return Rgb(0);
    const Ray ray = scattered_ray(at, sample);
    const std::optional<RayHit> hit = scene.rays.nearest(ray);
    if (!hit)
        return sample.weight * scene.scene.environment;
    const Interaction on = interact(scene, ray, *hit);
    const float part = weighed ? hit_weight(scene, on.point, ray.direction, hit->distance,
                                            source_at(at, sample.pdf))
                               : 1;
    return sample.weight * emitted_radiance(on.bsdf(), on.point, on.back) * part;
}

/// A box with a glossy floor, shiny walls, a ball of brushed metal, one of frosted glass and a
/// light.
Scene glossy_room()
{
    TriangleMesh walls = tiny::cube();
    tiny::turn_inside_out(walls);
    Scene scene = tiny::make_scene(walls);
    scene.materials[0] = glossy(tiny::diffuse({0.7f, 0.6f, 0.5f}), 0.5f);
    tiny::add(scene, tiny::floor_at(-0.45f, 0.9f), glossy(tiny::diffuse(Rgb(0.5f)), 0.2f));
    TriangleMesh ball = tiny::uv_sphere(24, 12);
    tiny::scale(ball, 0.15f);
    tiny::move(ball, {-0.2f, -0.25f, 0});
    tiny::add(scene, ball, glossy(tiny::mirror({0.9f, 0.7f, 0.4f}), 0.4f));
    tiny::move(ball, {0.4f, 0, 0});
    tiny::add(scene, ball, glossy(tiny::glass(1.5f), 0.25f));
    tiny::add(scene, tiny::floor_at(0.45f, -0.4f), tiny::emissive(Rgb(5)));
    scene.cameras[0].position = {0, 0, 0.48f};
    scene.cameras[0].tan_half_height = 0.8f;
    return scene;
}

} // namespace

TEST_CASE("glossy light: a point light's highlight is glTF's formula", "[integrator]")
{
    const double roughness = GENERATE(0.15, 0.4);
    Scene scene = tiny::diffuse_floor();
    const Rgb gold(1, 0.8f, 0.3f);
    scene.materials[0] = glossy(tiny::mirror(gold), static_cast<float>(roughness));
    ScenePointLight light;
    light.position = {0.2f, 0.25f, 0.1f};
    light.intensity = Rgb(3);
    scene.lights = {light};
    const auto ready = tiny::ready(scene);
    RandomSequence random(1, RandomStream::eye_paths, 0, 0);
    const Rgb seen =
        light_sampled_light(*ready->render, seen_along(*ready->render, aslant()), {1, 1}, random);
    // Appendix B of the specification, in double.
    const double alpha2 = std::pow(roughness, 4);
    const glm::dvec3 n(0, 1, 0), l = glm::normalize(glm::dvec3(light.position)),
                                 v = glm::normalize(glm::dvec3(-0.3, 0.2, 0)),
                                 h = glm::normalize(l + v);
    const double nl = glm::dot(n, l), nv = glm::dot(n, v), nh = glm::dot(n, h);
    const double d = alpha2 / (M_PI * std::pow(nh * nh * (alpha2 - 1) + 1, 2));
    const double mask = 1 / (nl * std::sqrt(nv * nv * (1 - alpha2) + alpha2) +
                             nv * std::sqrt(nl * nl * (1 - alpha2) + alpha2));
    const double grazing = std::pow(1 - glm::dot(v, h), 5);
    const double distance2 = glm::dot(glm::dvec3(light.position), glm::dvec3(light.position));
    for (int c = 0; c < 3; ++c)
        CHECK(seen[c] ==
              Approx((gold[c] + (1 - gold[c]) * grazing) * d * mask * 0.5 * nl * 3 / distance2)
                  .epsilon(1e-4));
}

TEST_CASE("glossy light: sampling lights and lobes together is sampling lobes alone",
          "[integrator]")
{
    const float roughness = GENERATE(0.1f, 0.3f, 0.5f);
    const bool glass = GENERATE(false, true);
    Scene scene = tiny::diffuse_floor();
    scene.materials[0] =
        glossy(glass ? tiny::glass(1.5f) : tiny::diffuse({0.5f, 0.3f, 0.1f}), roughness);
    scene.environment = Rgb(0.05f);
    TriangleMesh light = tiny::floor_at(0.2f, -0.25f);
    tiny::move(light, {0.35f, 0, 0});
    tiny::add(scene, light, tiny::emissive({2, 3, 4}));
    for (glm::vec3& p : light.positions)
        p.y = -p.y;
    tiny::turn_inside_out(light);
    tiny::add(scene, light, tiny::emissive({4, 3, 2})); // seen through rough glass
    const auto ready = tiny::ready(scene);
    const Interaction at = seen_along(*ready->render, aslant());
    RunningMean together, alone;
    for (std::uint64_t i = 0; i < 60000; ++i) {
        RandomSequence random(29, RandomStream::eye_paths, 0, i);
        Rgb both = light_sampled_light(*ready->render, at, {1, 1}, random), lobes(0.0f);
        if (at.gathers()) {
            both += bsdf_sampled_light(*ready->render, at, {.gathered = 1}, random);
            lobes += found_on_gloss(*ready->render, at, Lobes::gathered, false, random);
        }
        if (at.follows()) {
            both += found_on_gloss(*ready->render, at, Lobes::followed, true, random);
            lobes += found_on_gloss(*ready->render, at, Lobes::followed, false, random);
        }
        together.add(both.x);
        alone.add(lobes.x);
    }
    INFO("roughness " << roughness << (glass ? ", glass" : ", plastic"));
    CHECK(std::abs(together.mean() - alone.mean()) <
          kMostZ * std::hypot(together.standard_error(), alone.standard_error()));
    CHECK(alone.standard_error() < 0.03 * alone.mean());
}

TEST_CASE("glossy light: under a white sky each ball sends on its albedo", "[integrator]")
{
    struct Ball {
        const char* name;
        Material material;
    };
    const float roughness = GENERATE(0.2f, 0.6f);
    const Ball balls[] = {{"white metal", glossy(tiny::mirror(Rgb(1)), roughness)},
                          {"white plastic", glossy(tiny::diffuse(Rgb(1)), roughness)},
                          {"glass", glossy(tiny::glass(1.5f), roughness)}};
    for (const Ball& ball : balls) {
        Scene scene = tiny::make_scene(tiny::uv_sphere(32, 16));
        scene.materials[0] = ball.material;
        scene.environment = Rgb(1);
        const auto ready = tiny::ready(scene);
        Ray ray;
        ray.origin = {0.25f, 0.1f, 5};
        ray.direction = {0, 0, -1};
        const float cosine = seen_along(*ready->render, ray).cosine;
        RunningMean mean;
        for (std::uint64_t i = 0; i < 20000; ++i) {
            RandomSequence random(31, RandomStream::eye_paths, 0, i);
            mean.add(trace_path(*ready->render, ray, random).y);
        }
        INFO(ball.name << ", roughness " << roughness);
        const bool metal = ball.material.metallic > 0;
        if (ball.material.transmission == 0) {
            const double truth = metal ? glossy_albedo(cosine, roughness * roughness).white() : 1;
            CHECK(std::abs(mean.mean() - truth) < 0.003 + kMostZ * mean.standard_error());
        } else {
            CHECK(mean.mean() < 1 + kMostZ * mean.standard_error());
            CHECK(mean.mean() > 0.6); // facets lose what would be scattered again
        }
    }
}

TEST_CASE("glossy light: path tracer and photon maps agree on a glossy room", "[integrator]")
{
    const auto ready = tiny::ready(glossy_room());
    CHECK(ready->render->directional);
    ImageOptions options;
    options.width = 24;
    options.height = 16;
    options.photons = 20000;
    check_agreement(*ready, options, 8, 15, {.with_maps = Integrator::direct});
}

TEST_CASE("glossy light: what a plastic floor reflects onto the ceiling is counted once",
          "[integrator]")
{
    Scene scene = tiny::box(tiny::diffuse(Rgb(0.05f)));
    tiny::add(scene, tiny::floor_at(-0.45f, 1), glossy(tiny::diffuse(Rgb(0.02f)), 0.25f));
    tiny::add(scene, tiny::floor_at(0.45f, -0.4f), tiny::emissive(Rgb(5)));
    scene.cameras[0].position = {0.3f, 0, 0.3f}; // beside the lamp
    scene.cameras[0].forward = {0, 1, 0};
    scene.cameras[0].up = {0, 0, 1};
    scene.cameras[0].tan_half_height = 0.2f;
    const auto ready = tiny::ready(scene);
    ImageOptions options;
    options.width = options.height = 16;
    options.photons = 200000;
    options.integrator = Integrator::path;
    const RunningMean paths = means_of(*ready, options, 300);
    options.integrator = Integrator::progressive;
    const RunningMean maps = means_of(*ready, options, 32);
    const double noise = std::hypot(maps.standard_error(), paths.standard_error());
    INFO("maps " << maps.mean() << ", paths " << paths.mean() << ", noise " << noise);
    CHECK(std::abs(maps.mean() - paths.mean()) < 0.02 * paths.mean() + kMostZ * noise);
    CHECK(noise < 0.015 * paths.mean());
}
