#include "common/math/frame.h"
#include "common/math/sampling.h"
#include "render/lights/emission.h"
#include "tests/support/statistics.h"
#include "tests/support/tiny_rooms.h"

#include <catch2/catch.hpp>

using namespace hipmap;

namespace {

const SpotCone kCone{glm::normalize(glm::vec3(1, 2, -2)), std::cos(0.3f), std::cos(0.7f)};

SceneSpotLight spot_light()
{
    SceneSpotLight light;
    light.intensity = {1, 2, 3};
    light.direction = kCone.direction;
    light.cos_inner = kCone.cos_inner;
    light.cos_outer = kCone.cos_outer;
    return light;
}

/// Mean and spread of the power that reaches a set of directions, per steradian.
RunningMean emitted_in_cone(const LightSet& lights, const glm::vec3& axis, float cos_edge,
                            std::uint64_t paths)
{
    const EmissionPlan plan = plan_emission(lights, paths, Emitters::all);
    RunningMean mean;
    for (std::uint64_t i = 0; i < plan.paths; ++i) {
        RandomSequence random(5, RandomStream::photons, 0, i);
        const EmittedPath path = emit_path(lights, share_of(plan, i), random);
        const bool inside = glm::dot(path.ray.direction, axis) > cos_edge;
        mean.add(inside ? path.power.y * static_cast<double>(plan.paths) : 0.0);
    }
    return mean;
}

std::uint64_t paths_of(const EmissionPlan& plan, std::size_t light)
{
    return plan.first_path[light + 1] - plan.first_path[light];
}

/// A strong and a dim panel over a floor, each an object.
Scene two_panels(float strong, float dim)
{
    Scene scene = tiny::diffuse_floor();
    for (const float radiance : {strong, dim}) {
        TriangleMesh panel = tiny::floor_at(0.5f, -0.2f);
        tiny::move(panel, {radiance == strong ? -0.3f : 0.3f, 0, 0});
        tiny::add(scene, panel, tiny::emissive(Rgb(radiance)));
    }
    scene.mesh.object_names = {"floor", "strong", "dim"};
    scene.mesh.object_of_face = {0, 0, 1, 1, 2, 2};
    return scene;
}

} // namespace

TEST_CASE("spot cone: its integral is that of its fall-off", "[lights]")
{
    RunningMean mean;
    for (std::uint64_t i = 0; i < 200000; ++i) {
        RandomSequence random(1, RandomStream::photons, 0, i);
        mean.add(falloff(kCone, sample_sphere(random.next2())) * 4 * kPi);
    }
    CHECK(std::abs(mean.z_score(falloff_integral(kCone))) < kMostZ);
}

TEST_CASE("emission: a spot's light paths follow its intensity", "[lights]")
{
    Scene scene = tiny::diffuse_floor();
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
                Frame(kCone.direction).to_world(direction_from_cosine(cosine, 0.1f));
            truth += spot_light().intensity.y * falloff(kCone, direction) * 2 * kPi * height;
        }
        const RunningMean mean =
            emitted_in_cone(ready->render->lights, kCone.direction, std::cos(angle), 200000);
        CHECK(std::abs(mean.z_score(truth)) < kMostZ);
    }
}

TEST_CASE("emission: all paths together carry the power of the lights", "[lights]")
{
    Scene scene = tiny::diffuse_floor();
    tiny::add(scene, tiny::floor_at(0.5f, -0.3f), tiny::emissive({4, 5, 6}));
    scene.materials.back().double_sided = true;
    ScenePointLight point;
    point.intensity = {1, 2, 3};
    point.position = {0, 0.2f, 0};
    SceneSunLight sun;
    sun.irradiance = {3, 2, 1};
    scene.lights = {point, spot_light(), sun};
    scene.environment = {0.1f, 0.2f, 0.3f};
    const auto ready = tiny::ready(scene);
    const LightSet& lights = ready->render->lights;

    const EmissionPlan plan = plan_emission(lights, 10000, Emitters::all);
    glm::dvec3 sum(0);
    for (std::uint64_t i = 0; i < plan.paths; ++i) {
        RandomSequence random(5, RandomStream::photons, 0, i);
        sum += glm::dvec3(emit_path(lights, share_of(plan, i), random).power);
    }
    // Around the floor of side 1, half as high as it is wide: docs/light_transport.md (5), (7).
    const double radius2 = 0.25 * (1 + 1 + 0.25);
    const glm::dvec3 truth =
        4 * M_PI * glm::dvec3(1, 2, 3) + double{falloff_integral(kCone)} * glm::dvec3(1, 2, 3) +
        M_PI * radius2 * glm::dvec3(3, 2, 1) + 2.0 * M_PI * 0.09 * glm::dvec3(4, 5, 6) +
        4 * M_PI * M_PI * radius2 * glm::dvec3(0.1, 0.2, 0.3);
    for (int c = 0; c < 3; ++c)
        CHECK(sum[c] == Approx(truth[c]).epsilon(1e-4)); // every path of a light carries the same
}

TEST_CASE("emission: every light that emits has paths, a dark one has none", "[lights]")
{
    Scene scene = tiny::diffuse_floor();
    ScenePointLight bright, faint, dark;
    bright.intensity = Rgb(1e6f);
    faint.intensity = Rgb(1e-6f);
    scene.lights = {bright, dark, faint};
    const auto ready = tiny::ready(scene);
    const EmissionPlan plan = plan_emission(ready->render->lights, 1000, Emitters::all);
    CHECK(paths_of(plan, 0) >= 900);
    CHECK(paths_of(plan, 1) == 0);
    CHECK(paths_of(plan, 2) == 50); // its half of the floor share of a tenth
    CHECK(plan_emission(ready->render->lights, 0, Emitters::all).paths == 0);
    scene.lights = {dark};
    CHECK(plan_emission(tiny::ready(scene)->render->lights, 1000, Emitters::all).paths == 0);
}

TEST_CASE("emission: a dim emissive mesh beside a strong one has its floor share of paths",
          "[lights]")
{
    const auto ready = tiny::ready(two_panels(1e3f, 1e-3f));
    const LightSet& lights = ready->render->lights;
    REQUIRE(lights.lights.size() == 2);
    const EmissionPlan plan = plan_emission(lights, 10000, Emitters::all);
    CHECK(paths_of(plan, 0) == 9500);
    CHECK(paths_of(plan, 1) == 500);
    glm::dvec3 sums[2] = {};
    for (std::uint64_t i = 0; i < plan.paths; ++i) {
        const LightShare share = share_of(plan, i);
        RandomSequence random(5, RandomStream::photons, 0, i);
        const EmittedPath path = emit_path(lights, share, random);
        CHECK((path.ray.origin.x < 0) == (share.light == 0));
        sums[share.light] += glm::dvec3(path.power);
    }
    CHECK(sums[0].y == Approx(M_PI * 0.04 * 1e3).epsilon(1e-4));
    CHECK(sums[1].y == Approx(M_PI * 0.04 * 1e-3).epsilon(1e-4));
}

TEST_CASE("lights: direct light samples the faces of all emissive meshes together", "[lights]")
{
    const auto ready = tiny::ready(two_panels(3, 1));
    const EmissiveMesh& faces = ready->render->lights.faces;
    CHECK(faces.faces == std::vector<FaceId>{2, 3, 4, 5});
    CHECK(power(faces).y == Approx(M_PI * 0.04 * 4));
    CHECK_FALSE(faces.tree.empty());
}
