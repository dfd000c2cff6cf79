#include "common/input_error.h"
#include "tests/common/scene/tiny_gltf_file.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

namespace hipmap::tiny {

namespace {

/// A tetrahedron and a light on a node of its own.
GltfFile with_light(const json& light, const json& node = json::object())
{
    GltfFile file = tetrahedron_file();
    file.root["extensionsRequired"] = {"KHR_lights_punctual"};
    file.root["extensions"] = {{"KHR_lights_punctual", {{"lights", json::array({light})}}}};
    json holder = {{"name", "lamp"}, {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}};
    holder.update(node);
    file.root["nodes"].push_back(holder);
    file.root["scenes"][0]["nodes"] = {0, 1};
    return file;
}

GltfFile with_camera(const json& camera, const json& node = json::object())
{
    GltfFile file = tetrahedron_file();
    file.root["cameras"] = json::array({camera});
    json holder = {{"name", "eye"}, {"camera", 0}};
    holder.update(node);
    file.root["nodes"].push_back(holder);
    file.root["scenes"][0]["nodes"] = {0, 1};
    return file;
}

SceneLight only_light(const GltfFile& file, LightUnits units = LightUnits::spec)
{
    SceneOptions options;
    options.light_units = units;
    const Scene scene = load(file, options).scene;
    REQUIRE(scene.lights.size() == 1);
    return scene.lights[0];
}

const json kPerspective = {
    {"type", "perspective"},
    {"perspective", {{"yfov", 0.8}, {"aspectRatio", 1.5}, {"znear", 0.25}, {"zfar", 50}}}};

} // namespace

TEST_CASE("Blender's three lighting modes give the same light", "[scene][lights]")
{
    const double watts = 100, strength = 2.5;
    const struct {
        LightUnits units;
        double point, sun;
    } modes[] = {{LightUnits::spec, watts / (4 * std::numbers::pi) * 683, strength * 683},
                 {LightUnits::compat, watts / (4 * std::numbers::pi), strength},
                 {LightUnits::raw, watts, strength}};
    for (const auto& mode : modes) {
        for (const char* kind : {"point", "spot"}) {
            const SceneLight light = only_light(with_light({{"type", kind},
                                                            {"intensity", mode.point},
                                                            {"color", {1, 0.5, 0}},
                                                            {"spot", json::object()}}),
                                                mode.units);
            const glm::dvec3 intensity = std::string(kind) == "point"
                                             ? std::get<ScenePointLight>(light).intensity
                                             : std::get<SceneSpotLight>(light).intensity;
            CHECK(intensity.x == Approx(watts / (4 * std::numbers::pi)));
            CHECK(intensity.y == Approx(watts / (8 * std::numbers::pi)));
            CHECK(intensity.z == 0);
        }
        const auto sun = std::get<SceneSunLight>(
            only_light(with_light({{"type", "directional"}, {"intensity", mode.sun}}), mode.units));
        CHECK(sun.irradiance.x == Approx(strength));
    }
}

TEST_CASE("irradiance from a point light does not depend on the scene's size", "[scene][lights]")
{
    // At 2 m from 683 cd the irradiance is 1/4 W/m2, whatever the scene unit.
    for (const double size : {1e-3, 1.0, 1e3}) {
        GltfFile file =
            with_light({{"type", "point"}, {"intensity", 683}}, {{"translation", {0, 2, 0}}});
        file.root["nodes"][0]["scale"] = {size, size, size};
        const Scene scene = load(file).scene;
        const glm::dvec3 floor = -scene.frame.centre / scene.frame.metres_per_unit; // the origin
        const auto& light = std::get<ScenePointLight>(scene.lights.at(0));
        const glm::dvec3 away = light.position - floor;
        CHECK(light.intensity.x / glm::dot(away, away) == Approx(0.25).epsilon(1e-5));
    }
}

TEST_CASE("lights emit along their node's -Z and its scale means nothing", "[scene][lights]")
{
    // A quarter turn about x takes -Z to -Y.
    const double half = std::sqrt(0.5);
    const auto light = std::get<SceneSunLight>(only_light(with_light(
        {{"type", "directional"}}, {{"rotation", {-half, 0, 0, half}}, {"scale", {5, 0.1, 2}}})));
    CHECK(light.direction.x == Approx(0).margin(1e-6));
    CHECK(light.direction.y == Approx(-1));
    CHECK(light.direction.z == Approx(0).margin(1e-6));
    CHECK(light.name == "lamp");
}

TEST_CASE("a spot always has room to fall off between its cones", "[scene][lights]")
{
    for (const double outer : {1e-6, 0.3, std::numbers::pi / 4, 1.5707963705062866})
        for (const double blend : {0.0, 1e-9, 0.5, 1.0}) {
            const auto spot = std::get<SceneSpotLight>(only_light(with_light(
                {{"type", "spot"},
                 {"spot", {{"outerConeAngle", outer}, {"innerConeAngle", outer * (1 - blend)}}}})));
            CHECK(spot.cos_inner > spot.cos_outer);
            CHECK(spot.cos_inner <= 1.0f);
            CHECK(spot.cos_outer == Approx(std::cos(outer)).margin(1e-6));
        }
}

TEST_CASE("negative light is refused and an unknown kind is warned of", "[scene][lights]")
{
    CHECK_THROWS_WITH(load(with_light({{"type", "point"}, {"intensity", -10}})),
                      Catch::Contains("light 'lamp'"));
    CHECK_THROWS_AS(load(with_light({{"type", "point"}, {"color", {1, -1, 0}}})), InputError);
    CHECK_THROWS_AS(load(with_light({{"type", "spot"}, {"spot", {{"outerConeAngle", 0}}}})),
                    InputError);
    const LoadedScene laser = load(with_light({{"type", "laser"}}));
    CHECK(laser.scene.lights.empty());
    CHECK(says(laser.audit.warnings, "'laser'"));
}

TEST_CASE("a camera looks along its node's -Z, orthonormal whatever the scale", "[scene][camera]")
{
    const double half = std::sqrt(0.5);
    const json node = {
        {"translation", {4, 5, 6}}, {"rotation", {0, half, 0, half}}, {"scale", {3, 0.2, 7}}};
    const LoadedScene loaded = load(with_camera(kPerspective, node));
    const Scene& scene = loaded.scene;
    REQUIRE(scene.cameras.size() == 1);
    const Camera& camera = scene.cameras[0];
    const double unit = scene.frame.metres_per_unit;
    CHECK(camera.name == "eye");
    // A quarter turn about y takes -Z to -X.
    CHECK(glm::length(camera.forward - glm::vec3(-1, 0, 0)) < 1e-6f);
    CHECK(glm::length(camera.up - glm::vec3(0, 1, 0)) < 1e-6f);
    CHECK(glm::length(camera.right - glm::vec3(0, 0, -1)) < 1e-6f);
    CHECK(glm::length(scene.frame.centre + unit * glm::dvec3(camera.position) -
                      glm::dvec3(4, 5, 6)) < 1e-5);
    CHECK(camera.tan_half_height == Approx(std::tan(0.4)));
    CHECK(camera.aspect == 1.5f);
    CHECK(camera.near_clip * unit == Approx(0.25));
    CHECK(camera.far_clip * unit == Approx(50));
}

TEST_CASE("an orthographic camera's half height is in scene units", "[scene][camera]")
{
    GltfFile file =
        with_camera({{"type", "orthographic"},
                     {"orthographic", {{"xmag", 3}, {"ymag", 1.5}, {"znear", 0}, {"zfar", 10}}}});
    file.root["nodes"][0]["scale"] = {4, 4, 4};
    const Scene scene = load(file).scene;
    CHECK(scene.cameras.at(0).projection == Projection::orthographic);
    CHECK(scene.frame.metres_per_unit == 4.0);
    CHECK(scene.cameras[0].half_height == 0.375f);
    CHECK(scene.cameras[0].aspect == 2.0f);
}

TEST_CASE("a camera with an impossible lens is refused", "[scene][camera]")
{
    for (const char* key : {"yfov", "znear"}) {
        json camera = kPerspective;
        camera["perspective"][key] = -1;
        CHECK_THROWS_WITH(load(with_camera(camera)), Catch::Contains("camera 'eye'"));
    }
    json camera = kPerspective;
    camera["perspective"]["zfar"] = 0.1;
    CHECK_THROWS_AS(load(with_camera(camera)), InputError);
    CHECK_THROWS_WITH(load(with_camera(kPerspective, {{"scale", {1, 1, 0}}})),
                      Catch::Contains("scale 0"));
}

} // namespace hipmap::tiny
