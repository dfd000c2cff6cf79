#include "common/scene/named_lights.h"
#include "tests/common/scene/tiny_gltf_file.h"

#include <catch2/catch.hpp>

namespace hipmap::tiny {

namespace {

/// The tetrahedron as Blender 3.4 writes it, with a point light, a camera and an empty node.
GltfFile exported()
{
    GltfFile file = tetrahedron_file();
    json& root = file.root;
    root["asset"]["generator"] = "Khronos glTF Blender I/O v3.4.50";
    root["extensions"] = {
        {"KHR_lights_punctual", {{"lights", {{{"type", "point"}, {"intensity", 683}}}}}}};
    root["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 0.01}}}}};
    root["nodes"].push_back(
        {{"name", "Lamp"}, {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
    root["nodes"].push_back({{"name", "Eye"}, {"camera", 0}});
    root["nodes"].push_back({{"name", "Area"}});
    root["scenes"][0]["nodes"] = {0, 1, 2, 3};
    return file;
}

} // namespace

TEST_CASE("Blender's losses: objects of which nothing is left are named", "[scene][audit]")
{
    CHECK(says(load(exported()).audit.warnings, "nothing in 'Area': an Empty"));
    GltfFile filled = exported();
    filled.root["nodes"][3]["children"] = {2};
    filled.root["scenes"][0]["nodes"] = {0, 1, 3};
    CHECK_FALSE(says(load(filled).audit.warnings, "nothing in"));
    GltfFile bone = exported();
    bone.root["skins"] = {{{"joints", {3}}}};
    CHECK_FALSE(says(load(bone).audit.warnings, "nothing in"));
    GltfFile light = exported();
    light.root["nodes"][3]["extras"]["hipmap"] = {{"area_power", 10}, {"area_width", 1}};
    CHECK_FALSE(says(load(light).audit.warnings, "nothing in"));
    GltfFile other = exported();
    other.root["asset"].erase("generator");
    CHECK_FALSE(says(load(other).audit.warnings, "nothing in"));
}

TEST_CASE("Blender's losses: sizes of lights and depth of field", "[scene][audit]")
{
    const SceneAudit audit = load(exported()).audit;
    CHECK(says(audit.assumed, "lights without size: 'Lamp'"));
    CHECK(says(audit.assumed, "no depth of field: camera 'Eye'"));
    CHECK(says(audit.assumed, "hidden objects are rendered"));
    CHECK_FALSE(says(audit.assumed, "may have been hidden"));
    GltfFile sized = exported();
    sized.root["nodes"][1]["extras"]["hipmap"] = {{"radius", 0.1}};
    sized.root["nodes"][2]["extras"]["hipmap"] = {{"aperture_radius", 0.1}, {"focus_distance", 2}};
    CHECK_FALSE(says(load(sized).audit.assumed, "without size"));
    CHECK(describe_light(ScenePointLight{}).lacks_size);
    CHECK_FALSE(describe_light(SceneIesLight{}).lacks_size); // no file can give it one
    CHECK_FALSE(says(load(sized).audit.assumed, "no depth of field"));
}

TEST_CASE("Blender's losses: a file that the add-on completed has no unknown ones",
          "[scene][audit]")
{
    CHECK(says(load(exported()).audit.assumed, "modifiers are in the file if"));
    GltfFile completed = exported();
    completed.root["asset"]["generator"] =
        "Khronos glTF Blender I/O v3.4.50 (completed by hipmap for Blender)";
    const SceneAudit audit = load(completed).audit;
    CHECK(says(audit.assumed, "look as in Cycles"));
    CHECK_FALSE(says(audit.warnings, "nothing in"));
    for (const char* doubt : {"depth of field", "hidden objects", "modifiers", "without size"})
        CHECK_FALSE(says(audit.assumed, doubt));
}

TEST_CASE("Blender's losses: objects that are hidden by their names", "[scene][audit]")
{
    GltfFile file = exported();
    file.root["nodes"][0]["name"] = "Window Cutter.001";
    file.root["nodes"][3]["name"] = "Boolean"; // an empty
    CHECK(says(load(file).audit.assumed, "by its name, 'Window Cutter.001' may have been hidden"));
}

TEST_CASE("Blender's losses: a colour that may have come from nodes", "[scene][audit]")
{
    const auto names_it = [](const json& material) {
        GltfFile file = exported();
        file.root["materials"] = {material};
        return says(load(file).audit.assumed, "white base colour: 'wall'");
    };
    const json rough = {{"roughnessFactor", 0.5}};
    CHECK(names_it({{"name", "wall"}, {"pbrMetallicRoughness", rough}}));
    CHECK_FALSE(names_it(
        {{"name", "wall"}, {"pbrMetallicRoughness", {{"baseColorFactor", {1, 0.5, 0.5, 1}}}}}));
    CHECK_FALSE(names_it({{"name", "wall"},
                          {"pbrMetallicRoughness", rough},
                          {"extensions", {{"KHR_materials_transmission", json::object()}}}}));
}

TEST_CASE("a scene with lights but without a sky says so", "[scene][audit]")
{
    CHECK(says(load(exported()).audit.assumed, "no sky: the file has none"));
    SceneOptions options;
    options.environment = Rgb(0.0f);
    CHECK_FALSE(says(load(exported(), options).audit.assumed, "no sky"));
}

TEST_CASE("KHR_node_visibility hides a node and its children", "[scene]")
{
    GltfFile file = exported();
    file.root["nodes"].push_back({{"name", "group"}, {"children", {0, 1}}});
    file.root["nodes"].push_back({{"name", "copy"}, {"mesh", 0}});
    file.root["scenes"][0]["nodes"] = {4, 5};
    CHECK(load(file).scene.mesh.face_count() == 8);
    file.root["nodes"][4]["extensions"]["KHR_node_visibility"] = {{"visible", false}};
    const LoadedScene loaded = load(file);
    CHECK(loaded.scene.mesh.object_names == std::vector<std::string>{"copy"});
    CHECK(says(loaded.audit.found, "not rendered: 'group', 'thing' and 'Lamp'"));
    CHECK_FALSE(says(loaded.audit.found, "point light"));
    file.root["nodes"][4]["extensions"]["KHR_node_visibility"] = {{"visible", true}};
    CHECK(load(file).scene.mesh.face_count() == 8);
}

} // namespace hipmap::tiny
