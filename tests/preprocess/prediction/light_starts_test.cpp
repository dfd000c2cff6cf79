#include "preprocess/prediction/light_starts.h"
#include "tests/support/tiny_scenes.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace hipmap;

namespace {

RandomSequence random_of(std::uint64_t i)
{
    return {1, RandomStream::pictures, 0, i};
}

Scene lit_by(const std::vector<SceneLight>& lights)
{
    Scene scene = tiny::make_scene(tiny::floor_at(0, 1));
    scene.lights = lights;
    return scene;
}

} // namespace

TEST_CASE("light starts: paths are shared by power, a tenth of them evenly", "[prediction]")
{
    const Scene scene = lit_by({ScenePointLight{"a", {0, 1, 0}, glm::dvec3(9)},
                                ScenePointLight{"dark", {0, 2, 0}, glm::dvec3(0)},
                                ScenePointLight{"b", {0, 3, 0}, glm::dvec3(1)}});
    const std::vector<MeanMaterial> materials = mean_materials(scene);
    const MeanLights lights = collect_mean_lights(scene, materials);
    REQUIRE(lights.lights.size() == 2);
    CHECK(lights.cumulative[0] == Approx(0.05 + 0.9 * 0.9));
    CHECK(lights.cumulative[1] == Approx(1));
    RandomSequence random = random_of(0);
    CHECK(draw_light_point(lights, 0.85, random).position.y == 1);
    CHECK(draw_light_point(lights, 0.87, random).position.y == 3);
}

TEST_CASE("light starts: powers are those of the closed forms", "[prediction]")
{
    Scene scene =
        lit_by({SceneAreaLight{
                    "area", false, {0, 1, 0}, {0.5, 0, 0}, {0, 0, 0.25}, {0, -1, 0}, glm::dvec3(2)},
                SceneSunLight{"sun", {0, -1, 0}, glm::dvec3(3)}});
    scene.materials[0] = tiny::emissive(Rgb(4));
    scene.environment = Rgb(0.5f);
    const std::vector<MeanMaterial> materials = mean_materials(scene);
    const MeanLights lights = collect_mean_lights(scene, materials);
    REQUIRE(lights.lights.size() == 4);
    const double disc = M_PI * 0.5; // around a square of side 1
    CHECK(lights.lights[0].power == Approx(2 * M_PI * 0.5));
    CHECK(lights.lights[1].power == Approx(3 * disc));
    CHECK(lights.lights[2].power == Approx(4 * M_PI)); // one side of one square unit
    CHECK(lights.lights[3].power == Approx(0.5 * 4 * M_PI * disc));
}

TEST_CASE("light starts: aimed rays meet a target, and go only where the light sends light",
          "[prediction]")
{
    Scene scene = lit_by({SceneSpotLight{"spot", {0, 2, 0}, {0, -1, 0}, glm::dvec3(1), 0.95f, 0.9f},
                          SceneSunLight{"sun", {0, -1, 0}, glm::dvec3(3), 0.1}});
    const std::vector<MeanMaterial> materials = mean_materials(scene);
    const MeanLights lights = collect_mean_lights(scene, materials);
    const std::vector<BoundingSphere> targets = {{{0.2f, 0, 0}, 0.1f}, {{0.3f, 0, 0.1f}, 0.2f}};
    int sent = 0;
    for (std::uint64_t i = 0; i < 2000; ++i) {
        RandomSequence random = random_of(i);
        const LightPoint point = draw_light_point(lights, double(i) / 2000, random);
        const LightStart start = draw_aimed_start(lights, point, targets, random);
        if (is_black(start.power))
            continue;
        ++sent;
        CHECK(glm::dot(start.ray.direction, glm::vec3(0, -1, 0)) > 0.9f);
        CHECK(std::ranges::any_of(targets, [&](const BoundingSphere& target) {
            const glm::vec3 way = target.centre - start.ray.origin;
            return glm::length(glm::cross(way, start.ray.direction)) < 1.001f * target.radius;
        }));
    }
    CHECK(sent > 1000);
}
