#include "common/input_error.h"
#include "common/scene/named_lights.h"
#include "tests/common/scene/tiny_gltf_file.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

namespace hipmap::tiny {

namespace {

/// The extras in one of their two forms.
json extras(const json& values, bool as_text)
{
    return {{"hipmap", as_text ? json(values.dump()) : values}};
}

/// A tetrahedron of 2 m (so that a scene unit is 2 m), a light, a sun, a camera and an empty node.
GltfFile furnished()
{
    GltfFile file = tetrahedron_file();
    file.root["extensions"]["KHR_lights_punctual"]["lights"] = {
        {{"type", "point"}, {"intensity", 10}}, {{"type", "directional"}, {"intensity", 10}}};
    file.root["cameras"] = {
        {{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 0.1}}}}};
    const auto light = [](int index) { return json{{"KHR_lights_punctual", {{"light", index}}}}; };
    file.root["nodes"][0]["scale"] = {2, 2, 2};
    file.root["nodes"].push_back({{"name", "Lamp"}, {"extensions", light(0)}});
    file.root["nodes"].push_back({{"name", "Sun"}, {"extensions", light(1)}});
    file.root["nodes"].push_back({{"name", "Eye"}, {"camera", 0}, {"translation", {0, 0, 5}}});
    file.root["nodes"].push_back({{"name", "Area"}, {"translation", {0, 3, 0}}});
    file.root["scenes"][0]["nodes"] = {0, 1, 2, 3, 4};
    return file;
}

} // namespace

TEST_CASE("what glTF lacks is read from extras as an object and as JSON text",
          "[scene][gltf][extras]")
{
    for (const bool as_text : {false, true}) {
        GltfFile file = furnished();
        json& nodes = file.root["nodes"];
        nodes[1]["extras"] = extras({{"radius", 0.5}}, as_text);
        nodes[2]["extras"] = extras({{"angle_deg", 2}}, as_text);
        file.root["cameras"][0]["extras"] = extras({{"aperture_radius", 0.02}}, as_text);
        nodes[3]["extras"] = extras({{"focus_distance", 4}, {"shift_up", -0.25}}, as_text);
        nodes[4]["extras"] =
            extras({{"area_power", 100}, {"area_width", 2}, {"area_height", 3}}, as_text);
        file.root["materials"][0]["extras"] = extras({{"boundary", false},
                                                      {"medium",
                                                       {{"absorption", {1, 2, 3}},
                                                        {"scattering", {4, 5, 6}},
                                                        {"emission", {7, 8, 9}},
                                                        {"phase", "schlick"},
                                                        {"g", -0.5}}}},
                                                     as_text);
        file.root["scenes"][0]["extras"] =
            extras({{"world_color", {0.25, 0.5, 1}},
                    {"world_strength", 2},
                    {"medium", {{"scattering", {1, 2, 3}}, {"g", 0.75}}}},
                   as_text);
        const LoadedScene loaded = load(file);
        const Scene& scene = loaded.scene;
        REQUIRE(scene.frame.metres_per_unit == 2.0);
        CHECK(std::get<ScenePointLight>(scene.lights.at(0)).radius == 0.25f);
        CHECK(std::get<SceneSunLight>(scene.lights.at(1)).half_angle ==
              Approx(std::numbers::pi / 180));
        CHECK(scene.cameras.at(0).aperture_radius == Approx(0.01));
        CHECK(scene.cameras.at(0).focus_distance == 2.0f);
        CHECK(scene.cameras.at(0).shift == glm::vec2(0, -0.25f));
        CHECK(scene.materials.at(0).absorption == Rgb(2, 4, 6));
        CHECK(scene.materials.at(0).scattering == Rgb(8, 10, 12));
        CHECK(scene.materials.at(0).medium_emission == Rgb(14, 16, 18));
        CHECK(scene.materials.at(0).phase.kind == PhaseKind::schlick);
        CHECK(scene.materials.at(0).phase.g == -0.5f);
        CHECK(!scene.materials.at(0).boundary);
        CHECK(scene.around.scattering == Rgb(2, 4, 6));
        CHECK(scene.around.phase.kind == PhaseKind::henyey_greenstein);
        CHECK(scene.around.phase.g == 0.75f);
        CHECK(scene.environment == Rgb(0.5f, 1, 2));
        REQUIRE(scene.lights.size() == 3);
        const auto& area = std::get<SceneAreaLight>(scene.lights[2]);
        CHECK(area.name == "Area");
        CHECK(area.half_right == glm::dvec3(0.5, 0, 0));
        CHECK(area.half_up == glm::dvec3(0, 0.75, 0));
        CHECK(area.direction == glm::dvec3(0, 0, -1));
        // Power = pi times radiance times area.
        CHECK(area.radiance.x * std::numbers::pi * 6 == Approx(100));
        CHECK_FALSE(says(loaded.audit.warnings, "not rendered yet"));
        CHECK(says(loaded.audit.found, "area light 'Area'"));
    }
}

TEST_CASE("an area light may be a disc, takes its node's scale and emits along its -Z",
          "[scene][gltf][extras]")
{
    GltfFile file = furnished();
    json& node = file.root["nodes"][4];
    node["rotation"] = {-std::sqrt(0.5), 0, 0, std::sqrt(0.5)}; // -Z down
    node["scale"] = {3, 1, 1};
    node["extras"] = extras({{"area_power", 50},
                             {"area_width", 2},
                             {"area_shape", "disc"},
                             {"area_spread_deg", 90},
                             {"area_color", {1, 0.5, 0}}},
                            false);
    const auto area = std::get<SceneAreaLight>(load(file).scene.lights.at(2));
    CHECK(area.is_disc);
    CHECK(area.direction.y == Approx(-1));
    CHECK(glm::length(area.half_right) == Approx(1.5));
    CHECK(glm::length(area.half_up) == Approx(0.5));
    CHECK(area.radiance.x * std::numbers::pi * (std::numbers::pi * 3 * 1) == Approx(50));
    CHECK(area.radiance.y == Approx(0.5 * area.radiance.x));
    CHECK(area.radiance.z == 0.0f);
    CHECK(area.half_spread == Approx(std::numbers::pi / 4));
}

TEST_CASE("an area light without spread is a collimated beam", "[scene][gltf][extras]")
{
    GltfFile file = furnished();
    json& node = file.root["nodes"][4];
    node["translation"] = {1, 2, 3};
    node["extras"] = extras({{"area_power", 50},
                             {"area_width", 2},
                             {"area_height", 4},
                             {"area_spread_deg", 0},
                             {"area_color", {1, 0.5, 0}}},
                            false);
    const LoadedScene loaded = load(file);
    const auto beam = std::get<SceneBeamLight>(loaded.scene.lights.at(2));
    const double metres = loaded.scene.frame.metres_per_unit;
    CHECK_FALSE(beam.is_disc);
    CHECK(beam.direction.z == Approx(-1));
    CHECK(glm::length(beam.right - beam.centre) * metres == Approx(1));
    CHECK(glm::length(beam.up - beam.centre) * metres == Approx(2));
    CHECK(beam.irradiance.x == Approx(50 / 8.0)); // W/m2
    CHECK(beam.irradiance.y == Approx(25 / 8.0));
    CHECK(says(loaded.audit.found, "collimated beam"));
    CHECK_FALSE(describe_light(beam).has_size); // its shadows are sharp
}

TEST_CASE("keys that are not known are warned of by name", "[scene][gltf][extras]")
{
    GltfFile file = furnished();
    file.root["nodes"][1]["extras"] = extras({{"radius", 0.5}, {"raduis", 1}, {"glow", 2}}, true);
    CHECK(says(load(file).audit.warnings, "light 'Lamp': unknown key 'glow' and "
                                          "'raduis'"));
}

TEST_CASE("extras that make no sense are refused with their place and key",
          "[scene][gltf][extras][damaged]")
{
    const auto check_refused = [](std::size_t node, const json& hipmap, const char* what) {
        GltfFile file = furnished();
        file.root["nodes"][node]["extras"] = {{"hipmap", hipmap}};
        INFO(hipmap.dump());
        CHECK_THROWS_WITH(load(file), Catch::Contains("hipmap") && Catch::Contains(what));
    };
    check_refused(1, "radius = 1", "light 'Lamp'");
    check_refused(1, "", "light 'Lamp'");
    check_refused(1, std::string(100000, '['), "light 'Lamp'");
    check_refused(1, 7, "light 'Lamp'");
    check_refused(1, {{"radius", -1}}, "'radius'");
    check_refused(1, {{"radius", "big"}}, "'radius'");
    check_refused(2, {{"angle_deg", 181}}, "'angle_deg'");
    check_refused(3, "{\"focus_distance\": [1]}", "'focus_distance'");
    check_refused(4, {{"area_power", 1}}, "'area_width'");
    check_refused(4, {{"area_power", 1}, {"area_width", 1}, {"area_shape", "star"}}, "disc");
    check_refused(4, {{"area_power", 1}, {"area_width", 1}, {"area_color", {1, 1}}}, "area_color");
    check_refused(4, {{"area_power", 1}, {"area_width", 1}, {"area_spread_deg", -1}}, "0 or more");
    GltfFile file = furnished();
    file.root["scenes"][0]["extras"]["hipmap"] = {{"world_hdri", "../sky.hdr"}};
    CHECK_THROWS_WITH(load(file), Catch::Contains("'../sky.hdr'"));
    file.root["scenes"][0]["extras"]["hipmap"] = {{"world_turn_deg", 90}};
    CHECK_THROWS_WITH(load(file), Catch::Contains("'world_turn_deg'"));
    file.root["scenes"][0]["extras"]["hipmap"] = {{"world_turn_deg", 361},
                                                  {"world_hdri", "sky.hdr"}};
    CHECK_THROWS_WITH(load(file), Catch::Contains("'world_turn_deg'"));
    file = furnished();
    const auto check_medium_refused = [](const json& medium, const char* what) {
        GltfFile with = furnished();
        with.root["materials"][0]["extras"]["hipmap"] = {{"medium", medium}};
        CHECK_THROWS_WITH(load(with), Catch::Contains("'medium'") && Catch::Contains(what));
    };
    check_medium_refused({{"g", 1.5}}, "'g'");
    check_medium_refused({{"g", 0.5}, {"phase", "isotropic"}}, "'g'");
    check_medium_refused({{"phase", "mie"}}, "'phase'");
    check_medium_refused({{"scattering", {-1, 0, 0}}}, "'scattering'");
    check_medium_refused("fog", "object");
    file.root["materials"][0]["extras"]["hipmap"] = {{"priority", -1}};
    CHECK_THROWS_WITH(load(file), Catch::Contains("'priority'"));
    file.root["materials"][0]["extras"]["hipmap"] = {{"priority", 2}};
    CHECK(load(file).scene.materials.at(0).priority == 2);
    file.root["materials"][0]["extras"]["hipmap"] = {{"boundary", 1}};
    CHECK_THROWS_WITH(load(file), Catch::Contains("'boundary'"));
}

} // namespace hipmap::tiny
