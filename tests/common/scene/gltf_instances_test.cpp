#include "common/input_error.h"
#include "common/scene/fingerprint.h"
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
    GltfFile file = tetrahedron_file();
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
    GltfFile file = tetrahedron_file();
    const std::size_t corners = 120000;
    file.root["meshes"][0]["primitives"][0]["indices"] =
        file.add_indices(std::vector<std::uint16_t>(corners, 1));
    file.root["accessors"].push_back( // no data, so all zero
        {{"componentType", 5126}, {"count", 2 * corners}, {"type", "VEC3"}});
    instance_attributes(file) = {{"TRANSLATION", file.root["accessors"].size() - 1}};
    CHECK_THROWS_WITH(load(file), Catch::Contains("2^32 - 2 faces"));
}

namespace {

/// A tetrahedron in many places: turned and scaled, mirrored, scaled unevenly, and much larger.
GltfFile many_instances()
{
    GltfFile file = tetrahedron_file();
    std::vector<float> places, turns, scales;
    for (int i = 0; i < 12; ++i) {
        const glm::quat turn =
            glm::angleAxis(0.5f * static_cast<float>(i), glm::normalize(glm::vec3(1, i, 2)));
        places.insert(places.end(), {static_cast<float>(i), 0.5f * static_cast<float>(i % 3), 2});
        turns.insert(turns.end(), {turn.x, turn.y, turn.z, turn.w});
        const float scale = i == 7 ? 5.0f : 0.8f + 0.05f * static_cast<float>(i);
        scales.insert(scales.end(),
                      {i == 5 ? -scale : scale, i == 9 ? 1.3f * scale : scale, scale});
    }
    instance_attributes(file) = {{"TRANSLATION", file.add_vectors(places)},
                                 {"ROTATION", file.add_accessor(turns, "VEC4", 4, 5126)},
                                 {"SCALE", file.add_vectors(scales)}};
    return file;
}

SceneOptions copying(std::uint64_t least_faces)
{
    SceneOptions options;
    options.least_copied_faces = least_faces;
    return options;
}

} // namespace

TEST_CASE("instances that turn, scale and move one another are copies", "[scene][gltf][copies]")
{
    const Scene copied = load(many_instances(), copying(44)).scene;
    const Scene stored = load(many_instances(), copying(45)).scene;
    CHECK(stored.mesh.copies.empty());
    REQUIRE(stored.mesh.face_count() == 48);
    // Those that are mirrored, much larger and uneven are stored; the last two have no copies.
    CHECK(copied.mesh.copies.size() == 8);
    CHECK(copied.mesh.shared.size() == 1);
    REQUIRE(copied.mesh.face_count() == 16);
    REQUIRE(copied.mesh.all_face_count() == 48);
    CHECK(glm::distance(copied.frame.centre, stored.frame.centre) < 1e-12);
    CHECK(copied.frame.metres_per_unit == stored.frame.metres_per_unit);
    CHECK(glm::distance(copied.cameras[0].position, stored.cameras[0].position) < 1e-6f);
    // Stored instances come first, then copies, each in the order of the file.
    std::vector<FaceId> order;
    for (const bool is_stored : {true, false})
        for (FaceId i = 0; i < 12; ++i)
            if ((i == 0 || i == 5 || i == 7 || i == 9) == is_stored)
                for (FaceId face = 0; face < 4; ++face)
                    order.push_back(4 * i + face);
    for (FaceId face = 0; face < 48; ++face) {
        const auto found = copied.mesh.triangle(face), wanted = stored.mesh.triangle(order[face]);
        for (std::size_t c = 0; c < 3; ++c)
            CHECK(glm::distance(found[c], wanted[c]) < 1e-6f);
    }
}

TEST_CASE("instances are stored where something tells them apart", "[scene][gltf][copies]")
{
    const auto copies_of = [](const GltfFile& file, SceneOptions options = copying(1)) {
        return load(file, options).scene.mesh.copies.size();
    };
    CHECK(copies_of(many_instances()) == 8);
    GltfFile glowing = many_instances();
    glowing.root["materials"] = {{{"emissiveFactor", {1, 1, 1}}}};
    glowing.root["meshes"][0]["primitives"][0]["material"] = 0;
    CHECK(copies_of(glowing) == 0);
    GltfFile glass = many_instances();
    glass.root["materials"] = {
        {{"extensions", {{"KHR_materials_transmission", {{"transmissionFactor", 1}}}}}}};
    glass.root["meshes"][0]["primitives"][0]["material"] = 0;
    CHECK(copies_of(glass) == 0);
    SceneOptions excluding = copying(1);
    GltfFile two = many_instances();
    two.root["nodes"].push_back({{"mesh", 0}, {"name", "other"}});
    two.root["scenes"][0]["nodes"].push_back(two.root["nodes"].size() - 1);
    CHECK(copies_of(two) == 9);
    excluding.exclude = {"other"};
    CHECK(copies_of(two, excluding) == 0);
}

TEST_CASE("nodes that use one mesh are copies with objects of their own", "[scene][gltf][copies]")
{
    GltfFile file = tetrahedron_file();
    for (int i = 0; i < 3; ++i) {
        file.root["nodes"].push_back({{"mesh", 0},
                                      {"name", std::string("n").append(std::to_string(i))},
                                      {"translation", {2 * i + 2, 0, 0}}});
        file.root["scenes"][0]["nodes"].push_back(file.root["nodes"].size() - 1);
    }
    const Scene scene = load(file, copying(12)).scene;
    REQUIRE(scene.mesh.copies.size() == 3);
    for (std::uint32_t i = 0; i < 3; ++i)
        CHECK(scene.mesh.object_names[scene.mesh.object_of(scene.mesh.finder.first_face(i))] ==
              std::string("n").append(std::to_string(i)));
    CHECK(fingerprint(scene) != fingerprint(load(file, copying(13)).scene));
    GltfFile moved = file;
    moved.root["nodes"][2]["translation"] = {4, 0.25, 0};
    CHECK(fingerprint(scene) != fingerprint(load(moved, copying(12)).scene));
}

} // namespace hipmap::tiny
