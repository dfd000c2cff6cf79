#include "common/math/sampling.h"
#include "render/integrator/path_tracer.h"
#include "tests/support/form_factor.h"
#include "tests/support/mean_luminance.h"
#include "tests/support/render_image.h"
#include "tests/support/statistics.h"
#include "tests/support/tiny_rooms.h"

#include <catch2/catch.hpp>

using namespace hipmap;

namespace {

/// Radiance that one ray sees, over many paths.
RunningMean radiance_along(const tiny::ReadyScene& ready, const Ray& ray, std::uint64_t paths)
{
    RunningMean mean;
    for (std::uint64_t i = 0; i < paths; ++i) {
        RandomSequence random(23, RandomStream::eye_paths, 0, i);
        mean.add(trace_path(*ready.render, ray, random).y);
    }
    return mean;
}

Ray down_from(float y)
{
    Ray ray;
    ray.origin = {0, y, 0};
    ray.direction = {0, -1, 0};
    return ray;
}

} // namespace

TEST_CASE("path tracer: a closed diffuse sphere has radiance one", "[integrator]")
{
    const auto ready = tiny::ready(tiny::furnace());
    Ray ray;
    ray.origin = {0.1f, 0.05f, 0};
    ray.direction = glm::normalize(glm::vec3(0.3f, -0.2f, 0.9f));
    const RunningMean mean = radiance_along(*ready, ray, 20000);
    CHECK(std::abs(mean.z_score(1)) < kMostZ);
    CHECK(mean.standard_error() < 0.005);
}

TEST_CASE("path tracer: a floor under a point light and under a square light", "[integrator]")
{
    Scene scene = tiny::matt_floor();
    PunctualLight light;
    light.position = {0, 0.25f, 0};
    light.intensity = Rgb(3);
    scene.lights.push_back(light);
    const RunningMean point = radiance_along(*tiny::ready(scene), down_from(0.1f), 10);
    CHECK(point.mean() == Approx(0.5 / kPi * 3 / (0.25 * 0.25)).epsilon(1e-4));

    scene = tiny::matt_floor();
    tiny::add(scene, tiny::floor_at(0.3f, -0.4f), tiny::lamp(Rgb(2)));
    const RunningMean square = radiance_along(*tiny::ready(scene), down_from(0.1f), 40000);
    CHECK(std::abs(square.z_score(0.5 / kPi * 2 * 4 * corner_rectangle(0.2, 0.2, 0.3))) < kMostZ);
    CHECK(square.standard_error() < 0.01 * square.mean());
}

TEST_CASE("path tracer: facing mirrors pass an emitter's light on in a geometric series",
          "[integrator]")
{
    // Each mirror glows with 1 and reflects 0.7: the sum is 1 / (1 - 0.7).
    Material material = tiny::mirror(Rgb(0.7f));
    material.emission = Rgb(1);
    Scene scene = tiny::make_scene(tiny::floor_at(-0.2f, 1));
    scene.materials[0] = material;
    tiny::add(scene, tiny::floor_at(0.2f, -1), material);
    const RunningMean mean = radiance_along(*tiny::ready(scene), down_from(0), 20000);
    CHECK(std::abs(mean.z_score(1 / 0.3)) < kMostZ);
}

TEST_CASE("path tracer and photon maps agree on a room with glass and mirror", "[integrator]")
{
    const auto ready = tiny::ready(tiny::room());
    ImageOptions options;
    options.width = 24;
    options.height = 16;
    options.photons = 50000;
    RunningMean maps, paths;
    for (options.seed = 0; options.seed < 12; ++options.seed) {
        options.integrator = Integrator::direct;
        options.samples = 16;
        maps.add(mean_luminance(render_image(*ready->render, options, {}).image));
        options.integrator = Integrator::path;
        options.samples = 100;
        paths.add(mean_luminance(render_image(*ready->render, options, {}).image));
    }
    // Estimates blur across faceted balls and close corners, which leaves a bias below 1 part in
    // 100.
    const double noise = std::hypot(maps.standard_error(), paths.standard_error());
    CHECK(std::abs(maps.mean() - paths.mean()) < 0.01 * paths.mean() + kMostZ * noise);
    CHECK(noise < 0.01 * paths.mean());
}
