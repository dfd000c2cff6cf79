#include "common/input_error.h"
#include "tests/common/scene/tiny_gltf_file.h"

#include <catch2/catch.hpp>

namespace hipmap::tiny {

namespace {

/// The tetrahedron in a material with such extras.
GltfFile with_extras(const json& hipmap)
{
    GltfFile file = tetrahedron_file();
    file.root["materials"][0]["extras"]["hipmap"] = hipmap;
    return file;
}

} // namespace

TEST_CASE("reflection models are read from extras as an object and as JSON text",
          "[scene][gltf][extras]")
{
    const json phong{{"reflection", "phong"}, {"exponent", 40}, {"specular", {0.25, 0.5, 1}}};
    for (const json& written : {phong, json(phong.dump())}) {
        const Material material = load(with_extras(written)).scene.materials.at(0);
        CHECK(material.reflection_model == ReflectionModel::phong);
        CHECK(material.lobe_exponent == 40.0f);
        CHECK(material.lobe_specular == Rgb(0.25f, 0.5f, 1));
    }
    const json schlick{{"reflection", "schlick"}, {"isotropy", 0.25}};
    const LoadedScene loaded = load(with_extras(schlick));
    CHECK(loaded.scene.materials.at(0).reflection_model == ReflectionModel::schlick);
    CHECK(loaded.scene.materials.at(0).isotropy == 0.25f);
    CHECK_FALSE(says(loaded.audit.assumed, "model"));
    CHECK(load(with_extras({{"reflection", "schlick"}})).scene.materials.at(0).isotropy == 1.0f);
    const Material ward =
        load(with_extras(
                 {{"reflection", "ward"}, {"specular", {0.5, 0.5, 1}}, {"slopes", {0.4, 0.05}}}))
            .scene.materials.at(0);
    CHECK(ward.reflection_model == ReflectionModel::ward);
    CHECK(ward.lobe_specular == Rgb(0.5f, 0.5f, 1));
    CHECK(ward.ward_slopes == glm::vec2(0.4f, 0.05f));
    const Material lafortune = load(with_extras({{"reflection", "lafortune"},
                                                 {"specular", {0.5, 0.5, 1}},
                                                 {"exponent", 9},
                                                 {"coefficients", {-0.8, 0.2, 0.4}}}))
                                   .scene.materials.at(0);
    CHECK(lafortune.reflection_model == ReflectionModel::lafortune);
    CHECK(lafortune.lobe_exponent == 9.0f);
    CHECK(lafortune.lafortune_coefficients == glm::vec3(-1, 0.25f, 0.5f)); // only ratios count
    CHECK(load(tetrahedron_file()).scene.materials.at(0).reflection_model ==
          ReflectionModel::metallic_roughness);
}

TEST_CASE("tangents are read where a reflection model is anisotropic", "[scene][gltf][extras]")
{
    const json specular{0.5, 0.5, 0.5};
    const std::pair<json, bool> models[] = {
        {{{"reflection", "schlick"}}, false},
        {{{"reflection", "schlick"}, {"isotropy", 0.5}}, true},
        {{{"reflection", "ward"}, {"specular", specular}, {"slopes", {0.4, 0.1}}}, true},
        {{{"reflection", "lafortune"},
          {"specular", specular},
          {"exponent", 9},
          {"coefficients", {-1, -0.5, 1}}},
         true}};
    for (const auto& [extras, anisotropic] : models)
        for (const json& written : {extras, json(extras.dump())}) {
            GltfFile file = with_extras(written);
            file.root["meshes"][0]["primitives"][0]["attributes"]["TANGENT"] = file.add_accessor(
                std::vector<float>{1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1}, "VEC4", 4,
                5126);
            CHECK(load(file).scene.mesh.attributes.tangents.empty() != anisotropic);
        }
}

TEST_CASE("what a reflection model does not use is taken away and named", "[scene][gltf][extras]")
{
    GltfFile file =
        with_extras({{"reflection", "phong"}, {"exponent", 1e300}, {"specular", {1, 1, 1}}});
    json& material = file.root["materials"][0];
    material["pbrMetallicRoughness"] = {{"metallicFactor", 0.5}, {"roughnessFactor", 0.25}};
    material["extensions"] = {
        {"KHR_materials_transmission", {{"transmissionFactor", 1}}},
        {"KHR_materials_clearcoat", {{"clearcoatFactor", 1}}},
        {"KHR_materials_sheen", {{"sheenColorFactor", {1, 1, 1}}}},
        {"KHR_materials_diffuse_transmission", {{"diffuseTransmissionFactor", 1}}},
        {"KHR_materials_anisotropy", {{"anisotropyStrength", 1}}}};
    const LoadedScene loaded = load(file);
    CHECK(loaded.scene.materials.at(0).transmission == 0.0f);
    CHECK(loaded.scene.materials.at(0).clearcoat == 0.0f);
    CHECK(loaded.scene.materials.at(0).sheen_color == Rgb(0));
    CHECK(loaded.scene.materials.at(0).diffuse_transmission == 0.0f);
    CHECK(says(loaded.audit.assumed,
               "material 'paint' reflects by Phong's model, which ignores its 'metallicFactor', "
               "'roughnessFactor', 'KHR_materials_transmission'"));
    material["extras"]["hipmap"] = {{"reflection", "schlick"}};
    material["extensions"].erase("KHR_materials_transmission");
    CHECK(says(load(file).audit.assumed, "Schlick's model, which ignores its 'metallicFactor', "
                                         "'KHR_materials_clearcoat', 'KHR_materials_sheen' and "
                                         "'KHR_materials_diffuse_transmission'"));
    material["extras"]["hipmap"] = {
        {"reflection", "ward"}, {"specular", {1, 1, 1}}, {"slopes", {0.1, 0.2}}};
    CHECK(says(load(file).audit.assumed,
               "Ward's model, which ignores its 'metallicFactor', 'roughnessFactor', "
               "'KHR_materials_clearcoat', 'KHR_materials_sheen' and "
               "'KHR_materials_diffuse_transmission'"));
}

TEST_CASE("reflection models that make no sense are refused with their place and key",
          "[scene][gltf][extras][damaged]")
{
    const auto check_refused = [](const json& hipmap, const char* key, const char* what) {
        INFO(hipmap.dump());
        CHECK_THROWS_WITH(load(with_extras(hipmap)), Catch::Contains("material 'paint'") &&
                                                         Catch::Contains(key) &&
                                                         Catch::Contains(what));
    };
    check_refused({{"reflection", "blinn"}}, "'reflection'", "\"lafortune\"");
    check_refused({{"reflection", 1}}, "'reflection'", "text");
    check_refused({{"reflection", "phong"}, {"exponent", 5}}, "'reflection'", "\"specular\"");
    const auto phong = [](const json& exponent, const json& specular) {
        return json{{"reflection", "phong"}, {"exponent", exponent}, {"specular", specular}};
    };
    check_refused(phong(-1, {1, 1, 1}), "'exponent'", "0 or more");
    check_refused(phong(1, {1, 2, 1}), "'specular'", "from 0 to 1");
    check_refused(phong(1, 0.5), "'specular'", "three numbers");
    check_refused({{"exponent", 5}}, "'exponent'", "\"phong\"");
    check_refused({{"reflection", "schlick"}, {"specular", {1, 1, 1}}}, "'specular'", "\"phong\"");
    check_refused({{"isotropy", 0.5}}, "'isotropy'", "\"schlick\"");
    check_refused({{"reflection", "schlick"}, {"isotropy", 0}}, "'isotropy'", "above 0");
    check_refused({{"reflection", "schlick"}, {"isotropy", 1.5}}, "'isotropy'", "1 at most");
    const auto ward = [](const json& slopes) {
        return json{{"reflection", "ward"}, {"specular", {1, 1, 1}}, {"slopes", slopes}};
    };
    check_refused(ward({0.5}), "'slopes'", "2 numbers");
    check_refused(ward(0.5), "'slopes'", "2 numbers");
    check_refused(ward({0, 0.5}), "'slopes'", "above 0");
    check_refused(ward({0.5, 1.5}), "'slopes'", "to 1");
    check_refused({{"reflection", "ward"}, {"slopes", {0.5, 0.5}}}, "'reflection'", "\"specular\"");
    check_refused({{"slopes", {0.5, 0.5}}}, "'slopes'", "\"ward\"");
    const auto lafortune = [](const json& coefficients) {
        return json{{"reflection", "lafortune"},
                    {"specular", {1, 1, 1}},
                    {"exponent", 3},
                    {"coefficients", coefficients}};
    };
    check_refused(lafortune({0, 0, 0}), "'coefficients'", "one of them not 0");
    check_refused(lafortune({-1, -1, -0.5}), "'coefficients'", "0 or more");
    check_refused(lafortune({-1, -1, 2}), "'coefficients'", "to 1");
    check_refused(lafortune({-1, -1, "1"}), "'coefficients'", "3 numbers");
    check_refused({{"reflection", "lafortune"}, {"specular", {1, 1, 1}}, {"exponent", 3}},
                  "'reflection'", "\"coefficients\"");
    check_refused({{"reflection", "schlick"}, {"exponent", 3}}, "'exponent'",
                  "\"phong\" or \"lafortune\"");
    check_refused({{"reflection", "schlick"}, {"boundary", false}}, "'reflection'", "boundary");
}

} // namespace hipmap::tiny
