#include "tests/common/scene/tiny_gltf_file.h"

#include <catch2/catch.hpp>

#include <cmath>

namespace hipmap::tiny {

namespace {

constexpr const char* kBlender34 = "Khronos glTF Blender I/O v3.4.50";
constexpr const char* kBlender36 = "Khronos glTF Blender I/O v3.6.28";
constexpr const char* kBlender42 = "Khronos glTF Blender I/O v4.2.60";

GltfFile written_by(const json& generator)
{
    GltfFile file = tetrahedron_file();
    file.root["asset"]["generator"] = generator;
    return file;
}

SceneOptions asking(LookChoice look)
{
    SceneOptions options;
    options.look = look;
    return options;
}

Look look_of(const json& generator, LookChoice asked = LookChoice::automatic)
{
    return load(written_by(generator), asking(asked)).scene.look;
}

Material material_of(const char* generator)
{
    return load(written_by(generator)).scene.materials.at(0);
}

/// Clear glass that absorbs as Blender's exporter writes it.
GltfFile cider(const json& generator)
{
    GltfFile file = written_by(generator);
    file.root["materials"][0]["extensions"]["KHR_materials_volume"] = {
        {"thicknessFactor", 1}, {"attenuationDistance", 0.5}, {"attenuationColor", {0.2, 1, 0}}};
    return file;
}

Rgb absorption_of(const json& generator)
{
    const Scene scene = load(cider(generator)).scene;
    return scene.materials[0].absorption / static_cast<float>(scene.frame.metres_per_unit);
}

SceneSpotLight spot_of(const char* generator, double outer, double blend)
{
    GltfFile file = written_by(generator);
    file.root["extensions"]["KHR_lights_punctual"]["lights"] = {
        {{"type", "spot"},
         {"spot", {{"outerConeAngle", outer}, {"innerConeAngle", outer * (1 - blend)}}}}};
    file.root["nodes"].push_back({{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
    file.root["scenes"][0]["nodes"] = {0, 1};
    return std::get<SceneSpotLight>(load(file).scene.lights.at(0));
}

Material bare_material_of(const json& generator)
{
    GltfFile file = written_by(generator);
    file.root["meshes"][0]["primitives"][0].erase("material");
    const Scene scene = load(file).scene;
    return scene.materials[scene.mesh.material_of_face[0]];
}

} // namespace

TEST_CASE("look: that of the program and version that wrote the file", "[scene][look]")
{
    CHECK(load(tetrahedron_file()).scene.look == Look::gltf);
    CHECK(look_of("Khronos glTF Blender I/O v1.8.19") == Look::blender_3_4);
    CHECK(look_of(kBlender34) == Look::blender_3_4);
    CHECK(look_of("Khronos glTF Blender I/O v3.5.30") == Look::blender_3_6);
    CHECK(look_of(kBlender36) == Look::blender_3_6);
    CHECK(look_of("Khronos glTF Blender I/O v4.0.44") == Look::blender_4);
    CHECK(look_of("Khronos glTF Blender I/O v10.1") == Look::blender_4);
    CHECK(look_of("FBX2glTF v0.9.7") == Look::gltf);
    CHECK(look_of(3) == Look::gltf);
}

TEST_CASE("look: what was asked for, of the version that wrote the file", "[scene][look]")
{
    const char* const other = "FBX2glTF v0.9.7";
    for (const char* generator : {kBlender34, kBlender42, other})
        CHECK(look_of(generator, LookChoice::gltf) == Look::gltf);
    CHECK(look_of(kBlender36, LookChoice::blender) == Look::blender_3_6);
    CHECK(look_of(other, LookChoice::blender) == Look::blender_4);
    CHECK(look_of(kBlender36, LookChoice::blender3) == Look::blender_3_6);
    CHECK(look_of(kBlender42, LookChoice::blender3) == Look::blender_3_4);
    CHECK(look_of(other, LookChoice::blender3) == Look::blender_3_4);
    for (const Look look : {Look::gltf, Look::blender_3_4, Look::blender_4}) // of a state
        CHECK(look_of(other, choice_of(look)) == look);
}

TEST_CASE("look: the audit names one that is not glTF's", "[scene][look]")
{
    CHECK(says(load(written_by(kBlender34)).audit.assumed, "Blender up to 3.4 (--look gltf"));
    CHECK_FALSE(says(load(tetrahedron_file()).audit.assumed, "--look"));
}

TEST_CASE("look: materials of each version", "[scene][look]")
{
    const Material old = material_of(kBlender34), late = material_of(kBlender42);
    CHECK(old.diffuse_model == DiffuseModel::burley);
    CHECK(old.coat_adds);
    CHECK_FALSE(old.tint_by_root);
    CHECK_FALSE(old.energy_compensation);
    CHECK(late.diffuse_model == DiffuseModel::lambert);
    CHECK_FALSE(late.coat_adds);
    CHECK(late.tint_by_root);
    CHECK(late.energy_compensation);
    const Material plain = material_of("FBX2glTF v0.9.7");
    CHECK(plain.diffuse_model == DiffuseModel::lambert);
    CHECK_FALSE((plain.coat_adds || plain.tint_by_root || plain.energy_compensation));
}

TEST_CASE("look: Cycles absorbs (1 - colour) / distance, glTF -ln(colour) / distance",
          "[scene][look]")
{
    for (const char* generator : {kBlender34, kBlender42}) {
        const Rgb cycles = absorption_of(generator);
        CHECK(cycles.x == Approx(1.6));
        CHECK(cycles.y == Approx(0).margin(1e-6));
        CHECK(cycles.z == Approx(2));
    }
    CHECK(absorption_of("").x == Approx(-std::log(0.2) / 0.5));
}

TEST_CASE("look: a spot's rim begins where Blender's does", "[scene][look]")
{
    // 60 degrees to the rim's end, blend 0.25: cosines 0.5 and 0.5 + 0.5 * 0.25.
    const double outer = std::acos(0.5);
    for (const char* generator : {kBlender34, kBlender36, kBlender42}) {
        const SceneSpotLight spot = spot_of(generator, outer, 0.25);
        CHECK(spot.cos_outer == Approx(0.5));
        CHECK(spot.cos_inner == Approx(0.625));
        CHECK(spot_of(generator, outer, 1).cos_inner == Approx(1));
        const SceneSpotLight sharp = spot_of(generator, outer, 0);
        CHECK(sharp.cos_inner > sharp.cos_outer);
        CHECK(sharp.cos_inner == Approx(0.5));
    }
    CHECK(spot_of(kBlender34, outer, 0.25).falloff == SpotFalloff::smooth_cosine);
    CHECK(spot_of(kBlender36, outer, 0.25).falloff == SpotFalloff::smooth);
    CHECK(spot_of(kBlender42, outer, 0.25).falloff == SpotFalloff::smooth);
    const SceneSpotLight other = spot_of("", outer, 0.25);
    CHECK(other.falloff == SpotFalloff::gltf);
    CHECK(other.cos_inner == Approx(std::cos(0.75 * outer)));
    CHECK(spot_of(kBlender34, 2.0, 0.5).cos_outer >= 0);
}

TEST_CASE("look: without a material Blender shows grey Lambert, glTF white metal", "[scene][look]")
{
    const Material grey = bare_material_of(kBlender42);
    CHECK(grey.base_color == Rgb(0.8f));
    CHECK(grey.metallic == 0);
    CHECK(grey.specular == 0);
    CHECK(bare_material_of("").metallic == 1);
}

TEST_CASE("look: a custom property sets the diffuse lobe of one material", "[scene][look]")
{
    const auto model_of = [](const char* name) {
        GltfFile file = written_by(kBlender34);
        file.root["materials"][0]["extras"]["hipmap"] = {{"diffuse", name}};
        return load(file).scene.materials.at(0).diffuse_model;
    };
    CHECK(model_of("lambert") == DiffuseModel::lambert);
    CHECK(model_of("burley") == DiffuseModel::burley);
    CHECK(model_of("oren-nayar") == DiffuseModel::oren_nayar);
    CHECK_THROWS_WITH(model_of("phong"), Catch::Contains("\"oren-nayar\""));
}

TEST_CASE("look: OBJ files have it if asked for", "[scene][look]")
{
    const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    CHECK(load_text("bare.obj", triangle).scene.look == Look::gltf);
    const Scene scene = load_text("bare.obj", triangle, asking(LookChoice::blender3)).scene;
    CHECK(scene.materials.at(0).diffuse_model == DiffuseModel::burley);
}

} // namespace hipmap::tiny
