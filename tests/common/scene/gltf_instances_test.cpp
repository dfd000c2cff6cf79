#include "common/input_error.h"
#include "tests/common/scene/tiny_gltf_file.h"

#include <catch2/catch.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

#include <limits>

namespace hipmap::tiny {

namespace {

json& instance_attributes(GltfFile& file)
{
    return file.root["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"];
}

/// A tetrahedron that stands in two places, under a node that is moved and stretched.
GltfFile two_instances()
{
    GltfFile file = tetrahedron();
    file.root["extensionsRequired"] = {"EXT_mesh_gpu_instancing"};
    file.root["nodes"][0]["scale"] = {1, 2, 1};
    file.root["nodes"][0]["translation"] = {0, 0, 7};
    instance_attributes(file) = {
        {"TRANSLATION", file.add_vectors({10, 0, 0, 0, 20, 0})}, // accessor 2
        {"ROTATION",
         file.add_accessor(std::vector<std::int16_t>{0, 0, 0, 32767, 0, 0, 23170, 23170}, "VEC4", 4,
                           5122)},
        {"SCALE", file.add_vectors({1, 1, 1, -2, 3, 4})}};
    file.root["accessors"][3]["normalized"] = true;
    return file;
}

} // namespace

TEST_CASE("every instance becomes faces, placed by its own transform and then by its node's",
          "[scene][gltf][instances]")
{
    const Scene scene = load(two_instances()).scene;
    REQUIRE(scene.mesh.face_count() == 8);
    REQUIRE(scene.mesh.positions.size() == 8);
    CHECK(scene.mesh.object_names == std::vector<std::string>{"thing"});
    const glm::dmat4 node =
        glm::translate(glm::dmat4(1.0), {0, 0, 7}) * glm::scale(glm::dmat4(1.0), {1, 2, 1});
    const glm::dmat4 placed[] = {
        node * glm::translate(glm::dmat4(1.0), {10, 0, 0}),
        node * glm::translate(glm::dmat4(1.0), {0, 20, 0}) *
            glm::mat4_cast(glm::angleAxis(glm::radians(90.0), glm::dvec3(0, 0, 1))) *
            glm::scale(glm::dmat4(1.0), {-2, 3, 4})};
    const glm::dvec3 corners[] = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}}; // of the first face
    for (std::uint32_t i = 0; i < 2; ++i) {
        const glm::uvec3 face = scene.mesh.corners[4 * i];
        const bool mirrored = i == 1;
        const std::uint32_t order[] = {face.x, mirrored ? face.z : face.y,
                                       mirrored ? face.y : face.z};
        for (int c = 0; c < 3; ++c) {
            const glm::dvec3 wanted(placed[i] * glm::dvec4(corners[c], 1.0));
            CHECK(glm::length(world(scene, order[c]) - wanted) < 1e-4);
        }
    }
}

TEST_CASE("instances whose accessors disagree or are not finite are refused",
          "[scene][gltf][instances][damaged]")
{
    GltfFile file = two_instances();
    instance_attributes(file)["SCALE"] = file.add_vectors({1, 1, 1});
    CHECK_THROWS_WITH(load(file), Catch::Contains("nodes[0]") && Catch::Contains("SCALE"));
    file = two_instances();
    instance_attributes(file)["ROTATION"] = instance_attributes(file)["SCALE"];
    CHECK_THROWS_WITH(load(file), Catch::Contains("ROTATION"));
    file = two_instances();
    instance_attributes(file)["TRANSLATION"] =
        file.add_vectors({0, 0, 0, std::numeric_limits<float>::infinity(), 0, 0});
    CHECK_THROWS_WITH(load(file), Catch::Contains("instance 1"));
    file = two_instances();
    instance_attributes(file)["TRANSLATION"] = 99;
    CHECK_THROWS_WITH(load(file), Catch::Contains("TRANSLATION"));
}

TEST_CASE("more instances than faces can be counted are refused before they are made",
          "[scene][gltf][instances][damaged]")
{
    GltfFile file = tetrahedron();
    const std::size_t corners = 120000;
    file.root["meshes"][0]["primitives"][0]["indices"] =
        file.add_indices(std::vector<std::uint16_t>(corners, 1));
    file.root["accessors"].push_back( // no data, so all zero
        {{"componentType", 5126}, {"count", 2 * corners}, {"type", "VEC3"}});
    instance_attributes(file) = {{"TRANSLATION", file.root["accessors"].size() - 1}};
    CHECK_THROWS_WITH(load(file), Catch::Contains("2^32 - 2 faces"));
}

} // namespace hipmap::tiny
