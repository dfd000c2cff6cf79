#include "common/input_error.h"
#include "tests/common/scene/tiny_gltf_file.h"

#include <catch2/catch.hpp>

#include <cmath>

namespace hipmap::tiny {

namespace {

/// The one material of a tetrahedron whose longest side is `size` metres.
LoadedScene load_material(const json& material, double size = 1.0)
{
    GltfFile file = tetrahedron_file();
    file.root["nodes"][0]["scale"] = {size, size, size};
    file.root["materials"] = json::array({material});
    return load(file);
}

void check_colour(const Rgb& colour, double r, double g, double b)
{
    CHECK(colour.x == Approx(r));
    CHECK(colour.y == Approx(g));
    CHECK(colour.z == Approx(b));
}

} // namespace

TEST_CASE("a material's factors and extensions are read as glTF defines them", "[scene][gltf]")
{
    const Material m =
        load_material({{"name", "all"},
                       {"doubleSided", true},
                       {"emissiveFactor", {1.0, 0.5, 0.25}},
                       {"pbrMetallicRoughness",
                        {{"baseColorFactor", {0.1, 0.2, 0.3, 0.4}},
                         {"metallicFactor", 0.25},
                         {"roughnessFactor", 0.75}}},
                       {"extensions",
                        {{"KHR_materials_emissive_strength", {{"emissiveStrength", 8}}},
                         {"KHR_materials_transmission", {{"transmissionFactor", 0.9}}},
                         {"KHR_materials_ior", {{"ior", 1.33}}},
                         {"KHR_materials_specular",
                          {{"specularFactor", 0.5}, {"specularColorFactor", {0.6, 0.7, 0.8}}}}}}})
            .scene.materials.at(0);
    CHECK(m.name == "all");
    CHECK(m.double_sided);
    check_colour(m.base_color, 0.1, 0.2, 0.3);
    CHECK(m.metallic == 0.25f);
    CHECK(m.roughness == 0.75f);
    check_colour(m.emission, 8, 4, 2);
    CHECK(m.transmission == 0.9f);
    CHECK(m.ior == 1.33f);
    CHECK(m.specular == 0.5f);
    check_colour(m.specular_color, 0.6, 0.7, 0.8);
    check_colour(m.absorption, 0, 0, 0);
}

TEST_CASE("a volume that scatters sends back the colour that its file names", "[scene][gltf]")
{
    const auto load_wax = [](const json& scatter) {
        const double e = std::exp(1.0);
        return load_material(
            {{"extensions",
              {{"KHR_materials_volume",
                {{"attenuationDistance", 1}, {"attenuationColor", {1, 1 / e, 1 / (e * e)}}}},
               {"KHR_materials_volume_scatter", scatter}}}},
            1.0);
    };
    const LoadedScene loaded =
        load_wax({{"multiscatterColor", {0.5, 0.25, 0.8}}, {"scatterAnisotropy", 0.3}});
    CHECK(loaded.audit.warnings.empty());
    const Material& m = loaded.scene.materials.at(0);
    CHECK(m.phase.kind == PhaseKind::henyey_greenstein);
    CHECK(m.phase.g == 0.3f);
    check_colour(m.inside().extinction(), 0, 1, 2);
    CHECK(m.scattering.x == 0);
    for (const int c : {1, 2}) {
        // What comes back from a deep medium, by its albedo (van de Hulst's fit).
        const double albedo = m.scattering[c] / (m.scattering[c] + m.absorption[c]);
        const double s = std::sqrt((1 - albedo) / (1 - albedo * 0.3));
        CHECK((1 - s) * (1 - 0.139 * s) / (1 + 1.17 * s) ==
              Approx(c == 1 ? 0.25 : 0.8).epsilon(2e-4));
    }
    const Material black = load_wax({{"scatterAnisotropy", 0}}).scene.materials.at(0);
    CHECK(black.phase.kind == PhaseKind::isotropic);
    CHECK(max_channel(black.scattering) < 1e-4f);
    const Material white = load_wax({{"multiscatterColor", {1, 1, 1}}}).scene.materials.at(0);
    check_colour(white.absorption, 0, 0, 0);
    check_colour(white.scattering, 0, 1, 2);
    CHECK_THROWS_WITH(load_wax({{"scatterAnisotropy", 1}}), Catch::Contains("scatterAnisotropy"));
}

TEST_CASE("alpha, coat, sheen, anisotropy, dispersion and thickness are read", "[scene][gltf]")
{
    const LoadedScene loaded = load_material(
        {{"alphaMode", "MASK"},
         {"alphaCutoff", 0.25},
         {"pbrMetallicRoughness", {{"baseColorFactor", {1, 1, 1, 0.5}}}},
         {"extensions",
          {{"KHR_materials_clearcoat",
            {{"clearcoatFactor", 0.75}, {"clearcoatRoughnessFactor", 0.125}}},
           {"KHR_materials_sheen",
            {{"sheenColorFactor", {0.1, 0.2, 0.3}}, {"sheenRoughnessFactor", 0.375}}},
           {"KHR_materials_diffuse_transmission",
            {{"diffuseTransmissionFactor", 0.25},
             {"diffuseTransmissionColorFactor", {0.4, 0.5, 0.6}}}},
           {"KHR_materials_anisotropy", {{"anisotropyStrength", 0.625}, {"anisotropyRotation", 1}}},
           {"KHR_materials_dispersion", {{"dispersion", 0.1}}},
           {"KHR_materials_volume", {{"thicknessFactor", 0.5}}}}}},
        2.0);
    const Material& m = loaded.scene.materials.at(0);
    CHECK(m.alpha_mode == AlphaMode::mask);
    CHECK(m.alpha_cutoff == 0.25f);
    CHECK(m.alpha == 0.5f);
    CHECK(m.clearcoat == 0.75f);
    CHECK(m.clearcoat_roughness == 0.125f);
    check_colour(m.sheen_color, 0.1, 0.2, 0.3);
    CHECK(m.sheen_roughness == 0.375f);
    CHECK(m.diffuse_transmission == 0.25f);
    check_colour(m.diffuse_transmission_color, 0.4, 0.5, 0.6);
    CHECK(m.anisotropy == 0.625f);
    CHECK(m.anisotropy_rotation == 1.0f);
    CHECK(m.dispersion == 0.1f);
    REQUIRE(loaded.scene.frame.metres_per_unit == 2.0);
    CHECK(m.thickness == 0.25f);
    CHECK_FALSE(says(loaded.audit.warnings, "KHR_materials"));
    CHECK_THROWS_AS(load_material({{"alphaCutoff", -1}}), InputError);
}

TEST_CASE("what a material leaves out has glTF's default", "[scene][gltf]")
{
    const Material m = load_material(json::object()).scene.materials.at(0);
    check_colour(m.base_color, 1, 1, 1);
    CHECK(m.metallic == 1.0f);
    CHECK(m.roughness == 1.0f);
    check_colour(m.emission, 0, 0, 0);
    CHECK_FALSE(m.double_sided);
    CHECK(m.transmission == 0.0f);
    CHECK(m.ior == 1.5f);
    CHECK(m.specular == 1.0f);
    check_colour(m.specular_color, 1, 1, 1);
    CHECK(m.alpha_mode == AlphaMode::opaque);
    CHECK(m.alpha == 1.0f);
    CHECK(m.alpha_cutoff == 0.5f);
    CHECK(m.textures.empty());
}

TEST_CASE("absorption is per scene unit and finite for a black attenuation colour", "[scene][gltf]")
{
    // After attenuationDistance the attenuation colour is left: exp(-a d) = c.
    const LoadedScene loaded = load_material(
        {{"extensions",
          {{"KHR_materials_volume",
            {{"attenuationDistance", 0.25}, {"attenuationColor", {0.25, 1.0, 0.0}}}}}}},
        3.0);
    const double unit = loaded.scene.frame.metres_per_unit;
    REQUIRE(unit == 4.0);
    const Rgb absorption = loaded.scene.materials.at(0).absorption;
    CHECK(std::exp(-absorption.x * 0.25 / unit) == Approx(0.25));
    CHECK(absorption.y == 0.0f);
    CHECK(std::isfinite(absorption.z));
    CHECK(std::exp(-absorption.z * 0.25 / unit) < 1e-5);
}

TEST_CASE("factors beyond their range are clamped and warned of", "[scene][gltf]")
{
    const LoadedScene loaded =
        load_material({{"name", "odd"},
                       {"pbrMetallicRoughness", {{"roughnessFactor", 7}, {"metallicFactor", -1}}}});
    CHECK(loaded.scene.materials.at(0).roughness == 1.0f);
    CHECK(loaded.scene.materials.at(0).metallic == 0.0f);
    CHECK(says(loaded.audit.warnings, "'odd': 'metallicFactor' and 'roughnessFactor'"));
}

TEST_CASE("negative emission, a too small index of refraction and a huge number are refused",
          "[scene][gltf]")
{
    CHECK_THROWS_WITH(load_material({{"name", "m"}, {"emissiveFactor", {0, -1, 0}}}),
                      Catch::Contains("material 'm'") && Catch::Contains("emission"));
    CHECK_THROWS_AS(load_material({{"extensions", {{"KHR_materials_ior", {{"ior", 0.5}}}}}}),
                    InputError);
    CHECK_THROWS_AS(
        load_material({{"extensions", {{"KHR_materials_volume", {{"attenuationDistance", 0}}}}}}),
        InputError);
    CHECK_THROWS_WITH(load_material({{"name", "m"}, {"emissiveFactor", {1e300, 0, 0}}}),
                      Catch::Contains("material 'm'"));
}

TEST_CASE("emission that a float cannot hold is refused rather than taken for none",
          "[scene][gltf]")
{
    for (const double radiance : {1e-45, 1e-39, 1e39})
        CHECK_THROWS_WITH(load_material({{"name", "m"}, {"emissiveFactor", {0, radiance, 0}}}),
                          Catch::Contains("material 'm'"));
    CHECK(load_material({{"emissiveFactor", {0, 1e-37, 0}}}).scene.materials.at(0).emission.g > 0);
    CHECK(is_black(load_material({{"emissiveFactor", {0, 0, 0}}}).scene.materials.at(0).emission));
}

TEST_CASE("an unlit material emits its base colour and reflects nothing", "[scene][gltf]")
{
    const LoadedScene loaded =
        load_material({{"name", "sign"},
                       {"pbrMetallicRoughness", {{"baseColorFactor", {0.2, 0.4, 0.6, 1}}}},
                       {"extensions", {{"KHR_materials_unlit", json::object()}}}});
    check_colour(loaded.scene.materials.at(0).emission, 0.2, 0.4, 0.6);
    check_colour(loaded.scene.materials.at(0).base_color, 0, 0, 0);
    CHECK(says(loaded.audit.assumed, "'sign'"));
}

TEST_CASE("a lost node material and a missing material are spoken of", "[scene][gltf]")
{
    const LoadedScene lost =
        load_material({{"name", "glass"}, {"pbrMetallicRoughness", json::object()}});
    CHECK(says(lost.audit.warnings, "'glass' looks like a node material lost in export"));
    const LoadedScene kept =
        load_material({{"name", "steel"}, {"pbrMetallicRoughness", {{"roughnessFactor", 0.5}}}});
    CHECK_FALSE(says(kept.audit.warnings, "lost"));

    GltfFile bare = tetrahedron_file();
    bare.root["meshes"][0]["primitives"][0].erase("material");
    bare.root.erase("materials");
    const LoadedScene loaded = load(bare);
    CHECK(says(loaded.audit.assumed, "no material on 'thing'"));
    CHECK(loaded.scene.materials.size() == 1);
    CHECK(loaded.scene.mesh.material_of_face[0] == 0);
}

TEST_CASE("what is in a file but not read gets one warning by name", "[scene][gltf]")
{
    GltfFile file = tetrahedron_file();
    json& root = file.root;
    root["images"] = {{{"uri", "nowhere.png"}}};
    root["textures"] = {{{"source", 0}}};
    root["materials"] = json::array();
    for (int i = 0; i < 7; ++i)
        root["materials"].push_back(
            {{"name", std::string("m").append(std::to_string(i))},
             {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}},
             {"occlusionTexture", {{"index", 0}}}});
    root["materials"][0]["normalTexture"] = {{"index", 0}}; // rendered
    root["materials"][1]["alphaMode"] = "BLEND";            // rendered
    root["materials"][2]["extensions"] = {{"KHR_materials_iridescence", json::object()}};
    root["materials"][3]["extras"] = {{"hipmap", {{"fog", 1}}}};
    json& primitive = root["meshes"][0]["primitives"][0];
    primitive["attributes"]["COLOR_0"] = primitive["attributes"]["POSITION"];
    root["animations"] = {
        {{"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "pointer"}}}}}},
         {"samplers", {{{"input", 0}, {"output", 0}}}}}};
    root["extensionsUsed"] = {"KHR_materials_iridescence", "ACME_rounded_edges"};
    root["nodes"][0]["extensions"] = {{"ACME_springs", json::object()}};

    const SceneAudit audit = load(file).audit;
    const std::vector<std::string>& warnings = audit.warnings;
    for (const char* wanted :
         {"KHR_materials_iridescence", "'hipmap' of material 'm3': unknown key 'fog'",
          "animation of 'pointer'", "ACME_rounded_edges", "ACME_springs of objects ('thing')"}) {
        INFO(wanted);
        CHECK(says(warnings, wanted));
    }
    CHECK(says(warnings, "texture 'image 0' cannot be read"));
    CHECK_FALSE(says(warnings, "baseColorTexture")); // rendered
    CHECK_FALSE(says(warnings, "alpha"));
    CHECK(warnings.size() == 6);
    CHECK(says(audit.assumed, "occlusionTexture of materials ('m0', 'm1', 'm2', 'm3', 'm4' and 2 "
                              "more) is ignored"));
    CHECK(says(audit.assumed, "vertex colours (COLOR_0) of meshes ('tetrahedron')"));
}

} // namespace hipmap::tiny
