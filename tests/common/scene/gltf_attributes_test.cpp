#include "common/input_error.h"
#include "tests/common/scene/tiny_gltf_file.h"

#include <catch2/catch.hpp>

#include <limits>

namespace hipmap::tiny {

namespace {

json& attributes_of(GltfFile& file)
{
    return file.root["meshes"][0]["primitives"][0]["attributes"];
}

/// One triangle whose material reads a texture of each set and gives directions on the surface.
GltfFile textured_triangle()
{
    GltfFile file;
    file.root["images"] = {{{"uri", "nowhere.png"}}};
    file.root["textures"] = {{{"source", 0}}};
    file.root["materials"] = {{{"name", "tiles"},
                               {"normalTexture", {{"index", 0}, {"texCoord", 1}}},
                               {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
    const int positions = file.add_vectors({0, 0, 0, 1, 0, 0, 0, 1, 0});
    const int normals = file.add_vectors({0, 0, 1, 0, 0, 1, 0, 0, 1});
    file.root["meshes"] = {
        {{"primitives",
          {{{"attributes", {{"POSITION", positions}, {"NORMAL", normals}}}, {"material", 0}}}}}};
    file.root["nodes"] = {{{"name", "wall"}, {"mesh", 0}}};
    return file;
}

void normalise_last(GltfFile& file)
{
    file.root["accessors"].back()["normalized"] = true;
}

} // namespace

TEST_CASE("texture coordinates are read as floats and as fractions of bytes and shorts",
          "[scene][gltf][attributes]")
{
    GltfFile file = textured_triangle();
    attributes_of(file)["TEXCOORD_0"] =
        file.add_accessor(std::vector<float>{0, 0.25f, 1, -2, 3.5f, 1}, "VEC2", 2, 5126);
    attributes_of(file)["TEXCOORD_1"] =
        file.add_accessor(std::vector<std::uint16_t>{0, 65535, 32768, 0, 1, 2}, "VEC2", 2, 5123);
    normalise_last(file);
    const VertexAttributes read = load(file).scene.mesh.attributes;
    CHECK(read.uv[0] == std::vector<glm::vec2>{{0, 0.25f}, {1, -2}, {3.5f, 1}});
    REQUIRE(read.uv[1].size() == 3);
    CHECK(read.uv[1][0] == glm::vec2(0, 1));
    CHECK(read.uv[1][1].x == Approx(32768.0 / 65535));
    CHECK(read.uv[1][2].y == Approx(2.0 / 65535));

    attributes_of(file)["TEXCOORD_1"] =
        file.add_accessor(std::vector<std::uint8_t>{0, 255, 51, 0, 1, 2}, "VEC2", 2, 5121);
    normalise_last(file);
    CHECK(load(file).scene.mesh.attributes.uv[1][1].x == Approx(0.2));
}

TEST_CASE("attributes that no material reads take no memory", "[scene][gltf][attributes]")
{
    GltfFile file = textured_triangle();
    file.root["materials"] = {{{"name", "plain"}}};
    attributes_of(file)["TEXCOORD_0"] =
        file.add_accessor(std::vector<float>{0, 0, 1, 0, 0, 1}, "VEC2", 2, 5126);
    attributes_of(file)["TANGENT"] =
        file.add_accessor(std::vector<float>{1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1}, "VEC4", 4, 5126);
    const VertexAttributes read = load(file).scene.mesh.attributes;
    CHECK(read.uv[0].empty());
    CHECK(read.tangents.empty());
    CHECK(read.colours.empty());
    // Anisotropy needs a direction, even where no texture does.
    file.root["materials"][0]["extensions"] = {
        {"KHR_materials_anisotropy", {{"anisotropyStrength", 1}}}};
    const VertexAttributes wanted = load(file).scene.mesh.attributes;
    CHECK(wanted.uv[0].size() == 3);
    CHECK(wanted.tangents.size() == 3);
}

TEST_CASE("vertex colours are read with and without alpha and are white where there are none",
          "[scene][gltf][attributes]")
{
    GltfFile file = textured_triangle();
    attributes_of(file)["COLOR_0"] = file.add_accessor(
        std::vector<std::uint16_t>{65535, 0, 0, 0, 65535, 0, 0, 0, 65535}, "VEC3", 3, 5123);
    normalise_last(file);
    json bare = file.root["meshes"][0]["primitives"][0];
    bare["attributes"].erase("COLOR_0");
    json clear = bare;
    clear["attributes"]["COLOR_0"] = file.add_accessor(
        std::vector<float>{0.5f, 0.25f, 0.125f, 0.75f, 2, -1, 0, 1, 0, 0, 0, 0}, "VEC4", 4, 5126);
    file.root["meshes"][0]["primitives"] = {bare, file.root["meshes"][0]["primitives"][0], clear,
                                            bare};
    const LoadedScene loaded = load(file);
    const std::vector<glm::vec4> read = loaded.scene.mesh.attributes.colours;
    REQUIRE(read.size() == 12);
    for (const std::size_t i : {0, 1, 2, 9, 10, 11})
        CHECK(read[i] == glm::vec4(1.0f));
    CHECK(read[3] == glm::vec4(1, 0, 0, 1));
    CHECK(read[5] == glm::vec4(0, 0, 1, 1));
    CHECK(read[6] == glm::vec4(0.5f, 0.25f, 0.125f, 0.75f));
    CHECK(read[7] == glm::vec4(1, 0, 0, 1)); // clamped
    CHECK(says(loaded.audit.assumed, "vertex colours (COLOR_0)"));

    SceneOptions options;
    options.exclude = {"other"};
    file.root["nodes"].push_back({{"name", "other"}, {"mesh", 0}});
    file.root["scenes"][0]["nodes"] = {1, 0};
    CHECK(load(file, options).scene.mesh.attributes.colours == read);
}

TEST_CASE("tangents turn with their surface and change hands in a mirror",
          "[scene][gltf][attributes]")
{
    for (const double mirror : {1.0, -1.0}) {
        GltfFile file = textured_triangle();
        attributes_of(file)["TANGENT"] = file.add_accessor(
            std::vector<float>{1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, -1}, "VEC4", 4, 5126);
        const glm::dmat3 m(glm::dvec3(mirror * 2, 0, 1), glm::dvec3(0, 3, 0), glm::dvec3(1, 0, 1));
        file.root["nodes"][0]["matrix"] = {m[0].x, m[0].y, m[0].z, 0, m[1].x, m[1].y, m[1].z, 0,
                                           m[2].x, m[2].y, m[2].z, 0, 4,      5,      6,      1};
        const TriangleMesh mesh = load(file).scene.mesh;
        REQUIRE(mesh.attributes.tangents.size() == 3);
        for (std::size_t i = 0; i < 3; ++i) {
            const glm::dvec3 tangent(mesh.attributes.tangents[i]);
            CHECK(glm::length(tangent - glm::normalize(m[0])) < 1e-6);
            // The surface's own bitangent is +Y times w, which stays perpendicular here.
            const glm::dvec3 bitangent = glm::cross(glm::dvec3(mesh.normals[i]), tangent) *
                                         static_cast<double>(mesh.attributes.tangents[i].w);
            CHECK(glm::dot(bitangent, m[1]) * (i < 2 ? 1 : -1) > 0);
        }
    }
}

TEST_CASE("attributes of a wrong type or count or that are not finite are refused",
          "[scene][gltf][attributes][damaged]")
{
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const auto check_refused = [](const char* name, const std::vector<float>& values,
                                  const char* type, int components) {
        GltfFile file = textured_triangle();
        attributes_of(file)[name] = file.add_accessor(values, type, components, 5126);
        CHECK_THROWS_WITH(load(file), Catch::Contains(name));
    };
    check_refused("TEXCOORD_0", {0, 0, 0, 0}, "VEC2", 2);
    check_refused("TEXCOORD_0", {0, 0, 0, 0, 0, 0, 0, 0, 0}, "VEC3", 3);
    check_refused("TEXCOORD_1", {0, 0, 0, nan, 0, 0}, "VEC2", 2);
    check_refused("COLOR_0", {0, 0, 0, 0, 0, 0}, "VEC2", 2);
    check_refused("COLOR_0", {0, 0, 0, nan, 0, 0, 0, 0, 0}, "VEC3", 3);
    check_refused("TANGENT", {0, 0, 0, 0, 0, 0, 0, 0, 0}, "VEC3", 3);
}

} // namespace hipmap::tiny
