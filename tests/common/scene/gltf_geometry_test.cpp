#include "common/input_error.h"
#include "common/math/random.h"
#include "tests/common/scene/tiny_gltf_file.h"

#include <catch2/catch.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

#include <cmath>
#include <set>

namespace hipmap::tiny {

namespace {

/// Volume enclosed by the faces, in cubic metres: positive if they are wound outwards.
double signed_volume(const Scene& scene)
{
    double volume = 0.0;
    for (const glm::uvec3& face : scene.mesh.corners)
        volume +=
            glm::dot(world(scene, face.x), glm::cross(world(scene, face.y), world(scene, face.z))) /
            6;
    return volume;
}

/// Four corners of a face each at the same place whatever the file's way of listing them.
std::vector<glm::dvec3> corner_positions(const Scene& scene)
{
    std::vector<glm::dvec3> out;
    for (const glm::uvec3& face : scene.mesh.corners)
        for (int c = 0; c < 3; ++c)
            out.push_back(world(scene, face[c]));
    return out;
}

glm::dvec3 random_point(RandomSequence& random, double size)
{
    const double x = random.next(), y = random.next(), z = random.next();
    return (glm::dvec3(x, y, z) - 0.5) * size;
}

json numbers(const glm::dvec3& v)
{
    return {v.x, v.y, v.z};
}

} // namespace

TEST_CASE("a chain of nodes places vertices as the product of its transforms", "[scene][gltf]")
{
    RandomSequence random(7, RandomStream::pictures, 0, 0);
    for (int round = 0; round < 50; ++round) {
        GltfFile file = tetrahedron_file();
        glm::dmat4 expected(1.0);
        file.root["nodes"] = json::array();
        for (int depth = 0; depth < 3; ++depth) {
            const glm::dvec3 move = random_point(random, 20);
            const glm::dvec3 scale = random_point(random, 6);
            const glm::dvec3 turn = random_point(random, 6);
            const glm::dquat q(turn);
            expected = expected * glm::translate(glm::dmat4(1.0), move) * glm::mat4_cast(q) *
                       glm::scale(glm::dmat4(1.0), scale);
            file.root["nodes"].push_back({{"translation", numbers(move)},
                                          {"scale", numbers(scale)},
                                          {"rotation", {q.x, q.y, q.z, q.w}}});
            if (depth < 2)
                file.root["nodes"][static_cast<std::size_t>(depth)]["children"] = {depth + 1};
        }
        file.root["nodes"][2]["mesh"] = 0;
        const Scene scene = load(file).scene;
        const std::vector<glm::dvec3> corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
        REQUIRE(scene.mesh.positions.size() == 4);
        // The first face names corners 0, 2, 1: a mirrored transform swaps the last two.
        const bool mirrored = glm::determinant(expected) < 0;
        const glm::uvec3 face = scene.mesh.corners[0];
        for (const auto& [vertex, corner] :
             {std::pair{face.x, 0u}, {face.y, mirrored ? 1u : 2u}, {face.z, mirrored ? 2u : 1u}}) {
            const glm::dvec3 wanted(expected * glm::dvec4(corners[corner], 1.0));
            CHECK(glm::length(world(scene, vertex) - wanted) < 1e-6 * scene.frame.metres_per_unit);
        }
        CHECK(signed_volume(scene) ==
              Approx(std::abs(glm::determinant(expected)) / 6).epsilon(1e-4));
    }
}

TEST_CASE("the frame centres the box and makes its longest side at most 1 and more than half",
          "[scene]")
{
    for (const double size : {1e-100, 1e-6, 0.3, 1.0, 1.0000001, 2.0, 1e6, 1e100}) {
        GltfFile file = tetrahedron_file();
        file.root["nodes"][0]["scale"] = {size, size / 2, size / 3};
        file.root["nodes"][0]["translation"] = {7 * size, -size, size};
        const Scene scene = load(file).scene;
        glm::vec3 low(1), high(-1);
        for (const glm::vec3& p : scene.mesh.positions) {
            low = glm::min(low, p);
            high = glm::max(high, p);
        }
        const float longest = high.x - low.x;
        CHECK(longest > 0.5f);
        CHECK(longest <= 1.0f);
        CHECK(glm::length(low + high) < 1e-6f);
        int exponent = 0;
        CHECK(std::frexp(scene.frame.metres_per_unit, &exponent) == 0.5);
    }
}

TEST_CASE("a model moved to 1e6 m by its node keeps its shape", "[scene][gltf]")
{
    GltfFile near = tetrahedron_file(), far = tetrahedron_file();
    far.root["nodes"][0]["translation"] = {1e6, -1e6, 1e6};
    const Scene a = load(near).scene, b = load(far).scene;
    REQUIRE(a.mesh.positions.size() == b.mesh.positions.size());
    for (std::size_t i = 0; i < a.mesh.positions.size(); ++i)
        CHECK(glm::length(a.mesh.positions[i] - b.mesh.positions[i]) < 1e-7f);
}

TEST_CASE("normals stay perpendicular to stretched, sheared and mirrored faces", "[scene][gltf]")
{
    for (const double mirror : {1.0, -1.0}) {
        GltfFile file;
        const int positions = file.add_vectors({0, 0, 0, 1, 0, 0.5f, 0, 1, 0.25f});
        const int normals = file.add_vectors({-2, -1, 4, -2, -1, 4, -2, -1, 4});
        file.root["meshes"] = {
            {{"primitives", {{{"attributes", {{"POSITION", positions}, {"NORMAL", normals}}}}}}}};
        file.root["nodes"] = {
            {{"mesh", 0},
             {"matrix", {mirror * 3, 0, 0, 0, 0.7, 0.5, 0, 0, 0.2, 0.1, 2, 0, 5, 6, 7, 1}}}};
        const Scene scene = load(file).scene;
        const glm::dvec3 geometric = glm::normalize(scaled_normal(scene.mesh, 0));
        for (const glm::vec3& normal : scene.mesh.normals) {
            CHECK(glm::length(normal) == Approx(1.0f));
            CHECK(glm::dot(glm::dvec3(normal), geometric) == Approx(1.0).margin(1e-6));
        }
    }
}

TEST_CASE("triangles, strips and fans with and without indices give the same surface",
          "[scene][gltf]")
{
    const std::vector<float> square = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
    const std::vector<float> zigzag = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};
    const auto area_of = [](const std::vector<float>& positions, int mode,
                            const std::vector<std::uint16_t>& indices) {
        GltfFile file;
        json primitive = {{"attributes", {{"POSITION", file.add_vectors(positions)}}},
                          {"mode", mode}};
        if (!indices.empty())
            primitive["indices"] = file.add_indices(indices);
        file.root["meshes"] = {{{"primitives", json::array({primitive})}}};
        file.root["nodes"] = {{{"mesh", 0}}};
        const Scene scene = load(file).scene;
        REQUIRE(scene.mesh.face_count() == 2);
        glm::dvec3 sum(0.0);
        for (FaceId face = 0; face < 2; ++face)
            sum += 0.5 * scaled_normal(scene.mesh, face);
        CHECK(glm::length(sum - glm::dvec3(0, 0, 1)) < 1e-6); // unit area, all towards +Z
    };
    area_of(square, 4, {0, 1, 2, 0, 2, 3});
    area_of({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0, 1, 1, 0, 0, 1, 0}, 4, {});
    area_of(zigzag, 5, {});
    area_of(zigzag, 5, {0, 1, 2, 3});
    area_of(square, 6, {});
    area_of(square, 6, {0, 1, 2, 3});
}

TEST_CASE("every index type, stride and encoding of positions gives the same faces",
          "[scene][gltf]")
{
    const std::vector<glm::dvec3> plain = corner_positions(load(tetrahedron_file()).scene);

    SECTION("8-bit indices")
    {
        GltfFile file = tetrahedron_file();
        file.root["meshes"][0]["primitives"][0]["indices"] = file.add_accessor(
            std::vector<std::uint8_t>{0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3}, "SCALAR", 1, 5121);
        CHECK(corner_positions(load(file).scene) == plain);
    }
    SECTION("32-bit indices")
    {
        GltfFile file = tetrahedron_file();
        file.root["meshes"][0]["primitives"][0]["indices"] = file.add_accessor(
            std::vector<std::uint32_t>{0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3}, "SCALAR", 1, 5125);
        CHECK(corner_positions(load(file).scene) == plain);
    }
    SECTION("interleaved")
    {
        GltfFile file = tetrahedron_file();
        const int positions = file.add_vectors(
            {0, 0, 0, 9, 9, 9, 1, 0, 0, 9, 9, 9, 0, 1, 0, 9, 9, 9, 0, 0, 1, 9, 9, 9});
        file.root["accessors"][static_cast<std::size_t>(positions)]["count"] = 4;
        file.root["bufferViews"].back()["byteStride"] = 24;
        file.root["meshes"][0]["primitives"][0]["attributes"]["POSITION"] = positions;
        CHECK(corner_positions(load(file).scene) == plain);
    }
    SECTION("sparse without a base")
    {
        GltfFile file = tetrahedron_file();
        file.add_accessor(std::vector<std::uint16_t>{1, 2, 3}, "SCALAR", 1, 5123);
        file.add_vectors({1, 0, 0, 0, 1, 0, 0, 0, 1});
        const std::size_t views = file.root["bufferViews"].size();
        file.root["accessors"].erase(file.root["accessors"].size() - 1);
        file.root["accessors"].back() = {
            {"componentType", 5126},
            {"count", 4},
            {"type", "VEC3"},
            {"sparse",
             {{"count", 3},
              {"indices", {{"bufferView", views - 2}, {"componentType", 5123}}},
              {"values", {{"bufferView", views - 1}}}}}};
        file.root["meshes"][0]["primitives"][0]["attributes"]["POSITION"] =
            file.root["accessors"].size() - 1;
        CHECK(corner_positions(load(file).scene) == plain);
    }
    SECTION("quantised")
    {
        GltfFile file = tetrahedron_file();
        const int positions = file.add_accessor(
            std::vector<std::int16_t>{0, 0, 0, 32767, 0, 0, 0, 32767, 0, 0, 0, 32767}, "VEC3", 3,
            5122);
        file.root["accessors"][static_cast<std::size_t>(positions)]["normalized"] = true;
        file.root["extensionsRequired"] = {"KHR_mesh_quantization"};
        file.root["meshes"][0]["primitives"][0]["attributes"]["POSITION"] = positions;
        CHECK(corner_positions(load(file).scene) == plain);
    }
}

TEST_CASE("instances bear their nodes' names and primitives their materials", "[scene][gltf]")
{
    GltfFile file = tetrahedron_file();
    file.root["nodes"].push_back({{"name", "other"}, {"mesh", 0}, {"translation", {3, 0, 0}}});
    file.root["scenes"][0]["nodes"] = {0, 1};
    file.root["materials"].push_back({{"name", "lacquer"}});
    json second = file.root["meshes"][0]["primitives"][0];
    second["material"] = 1;
    file.root["meshes"][0]["primitives"].push_back(second);
    const Scene scene = load(file).scene;
    CHECK(scene.mesh.object_names == std::vector<std::string>{"thing", "other"});
    REQUIRE(scene.mesh.face_count() == 16);
    for (FaceId face = 0; face < 16; ++face) {
        CHECK(scene.mesh.object_of_face[face] == face / 8);
        CHECK(scene.mesh.material_of_face[face] == face / 4 % 2);
    }
}

TEST_CASE("vertices that no face uses are left out of the box, degenerate faces stay",
          "[scene][gltf]")
{
    GltfFile file = tetrahedron_file();
    file.root["meshes"][0]["primitives"][0]["attributes"]["POSITION"] =
        file.add_vectors({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, -1e30f, 1e30f, 0});
    file.root["meshes"][0]["primitives"][0]["indices"] =
        file.add_indices({0, 2, 1, 1, 1, 1, 0, 0, 2, 1, 2, 3});
    const Scene scene = load(file).scene;
    CHECK(scene.mesh.face_count() == 4);
    CHECK(scene.mesh.positions.size() == 4);
    CHECK(scene.frame.metres_per_unit == 1.0);
    CHECK(scene.frame.centre == glm::dvec3(0.5));
}

TEST_CASE("the default scene is taken and, without scenes, all root nodes", "[scene][gltf]")
{
    GltfFile file = tetrahedron_file();
    file.root["nodes"].push_back({{"name", "second"}, {"mesh", 0}});
    file.root["scenes"] = {{{"nodes", {0}}}, {{"nodes", {1}}, {"name", "Attic"}}};
    file.root["scene"] = 1;
    const LoadedScene second = load(file);
    CHECK(second.scene.mesh.object_names == std::vector<std::string>{"second"});
    CHECK(says(second.audit.assumed, "'Attic'"));
    file.root.erase("scene");
    CHECK(load(file).scene.mesh.object_names == std::vector<std::string>{"thing"});
    file.root.erase("scenes");
    CHECK(load(file).scene.mesh.object_names == std::vector<std::string>{"thing", "second"});
}

TEST_CASE("the same file gives the same bits however its buffer is stored", "[scene][gltf]")
{
    const GltfFile file = tetrahedron_file();
    const TemporaryFolder folder;
    GltfFile separate = file;
    separate.root["buffers"] = {{{"byteLength", file.bytes.size()}, {"uri", "my%20data+1.bin"}}};
    write_text(folder / "my data+1.bin", file.bytes + "left over");
    write_text(folder / "scene.gltf", separate.text());
    const Scene a = load(file).scene, b = load_scene(folder / "scene.gltf", {}).scene;
    CHECK(a.mesh.positions == b.mesh.positions);
    CHECK(a.mesh.corners == b.mesh.corners);
}

} // namespace hipmap::tiny
