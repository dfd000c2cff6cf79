#include "common/file/output_file.h"
#include "common/math/bounds.h"
#include "common/scene/load_scene.h"
#include "preprocess/colouring/coloured_glb.h"
#include "preprocess/colouring/map_colours.h"
#include "preprocess/partition/build_partition.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/tiny_meshes.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <cstring>

using namespace hipmap;

namespace {

/// A cube and a sphere whose faces alternate, so that the file must put them in order.
Scene two_objects()
{
    Scene scene = tiny::make_scene(tiny::together(tiny::uv_sphere(6, 3), tiny::cube()));
    TriangleMesh& mesh = scene.mesh;
    mesh.object_names = {"never used",
                         "K\xc3\xbc"
                         "gel \"1\"",
                         "Cube"};
    for (FaceId face = 0; face < mesh.face_count(); ++face)
        mesh.object_of_face[face] = face < mesh.face_count() - 12 ? 1 : 2;
    std::swap(mesh.corners[0], mesh.corners.back());
    std::swap(mesh.object_of_face[0], mesh.object_of_face.back());
    scene.frame.centre = {1e6, -3, 0.25};
    scene.frame.metres_per_unit = 8;
    return scene;
}

struct GlbFile {
    nlohmann::json json;
    std::vector<std::byte> binary;
};

std::uint32_t word_at(const std::vector<std::byte>& bytes, std::size_t at)
{
    std::uint32_t word = 0;
    REQUIRE(at + 4 <= bytes.size());
    std::memcpy(&word, &bytes[at], 4);
    return word;
}

/// Takes a container apart and checks its lengths and alignment against the specification.
GlbFile take_apart(const std::filesystem::path& path)
{
    const std::vector<std::byte> bytes = read_file(path);
    REQUIRE(word_at(bytes, 0) == 0x46546c67);
    REQUIRE(word_at(bytes, 4) == 2);
    REQUIRE(word_at(bytes, 8) == bytes.size());
    const std::uint32_t json_size = word_at(bytes, 12);
    REQUIRE(json_size % 4 == 0);
    REQUIRE(word_at(bytes, 16) == 0x4e4f534a);
    const auto* text = reinterpret_cast<const char*>(bytes.data()) + 20;
    const std::size_t binary = 20 + json_size;
    REQUIRE(word_at(bytes, binary) == bytes.size() - binary - 8);
    REQUIRE(word_at(bytes, binary) % 4 == 0);
    REQUIRE(word_at(bytes, binary + 4) == 0x004e4942);
    return {nlohmann::json::parse(text, text + json_size),
            {bytes.begin() + static_cast<std::ptrdiff_t>(binary) + 8, bytes.end()}};
}

std::vector<glm::vec3> values_of(const GlbFile& file, std::size_t number)
{
    const auto& accessor = file.json["accessors"][number];
    const auto& view = file.json["bufferViews"][accessor["bufferView"].get<std::size_t>()];
    CHECK(accessor["componentType"] == 5126);
    CHECK(accessor["type"] == "VEC3");
    const std::size_t count = accessor["count"];
    const std::size_t offset = accessor["byteOffset"];
    REQUIRE(view["byteStride"] == 12);
    REQUIRE(offset + 12 * count <= view["byteLength"].get<std::size_t>());
    REQUIRE(view["byteOffset"].get<std::size_t>() + view["byteLength"].get<std::size_t>() <=
            file.binary.size());
    std::vector<glm::vec3> values(count);
    std::memcpy(static_cast<void*>(values.data()),
                &file.binary[view["byteOffset"].get<std::size_t>() + offset], 12 * count);
    return values;
}

} // namespace

TEST_CASE("write_coloured_glb: our loader finds every face where it was, by object", "[colouring]")
{
    const TemporaryFolder folder;
    const Scene scene = two_objects();
    write_coloured_glb(folder / "a.glb", scene, build_partition(scene, {}).partition);
    const LoadedScene loaded = load_scene(folder / "a.glb", {});
    const TriangleMesh& back = loaded.scene.mesh;
    REQUIRE(back.face_count() == scene.mesh.face_count());
    CHECK(back.object_names == std::vector<std::string>{scene.mesh.object_names[1], "Cube"});
    CHECK(loaded.scene.materials.at(0).name == "Shared maps");

    std::vector<FaceId> order; // object by object
    for (const ObjectId object : {1u, 2u})
        for (FaceId face = 0; face < scene.mesh.face_count(); ++face)
            if (scene.mesh.object_of_face[face] == object)
                order.push_back(face);
    const auto place = [](const Scene& of, FaceId face, int c) {
        const glm::dvec3 p(of.mesh.positions[of.mesh.corners[face][c]]);
        return of.frame.centre + of.frame.metres_per_unit * p;
    };
    for (FaceId face = 0; face < back.face_count(); ++face) {
        CHECK(back.object_of_face[face] + 1 == scene.mesh.object_of_face[order[face]]);
        for (int c = 0; c < 3; ++c)
            REQUIRE(glm::distance(place(loaded.scene, face, c), place(scene, order[face], c)) <
                    1e-5);
    }
}

TEST_CASE("write_coloured_glb: vertices have the colours of their maps, and bounds are true",
          "[colouring]")
{
    const TemporaryFolder folder;
    const Scene scene = two_objects();
    const Partition partition = build_partition(scene, {}).partition;
    write_coloured_glb(folder / "a.glb", scene, partition);
    const GlbFile file = take_apart(folder / "a.glb");
    CHECK(file.json["asset"]["version"] == "2.0");
    CHECK(file.json["buffers"][0]["byteLength"] == file.binary.size());
    CHECK(file.json["scenes"][0]["nodes"] == nlohmann::json{0, 1});
    REQUIRE(file.json["meshes"].size() == 2);

    std::vector<glm::vec3> colours;
    for (const auto& mesh : file.json["meshes"]) {
        const auto& attributes = mesh["primitives"][0]["attributes"];
        const auto& accessor = file.json["accessors"][attributes["POSITION"].get<std::size_t>()];
        Bounds<glm::vec3> box;
        for (const glm::vec3& p : values_of(file, attributes["POSITION"]))
            box.add(p);
        for (int axis = 0; axis < 3; ++axis) {
            CHECK(accessor["min"][static_cast<std::size_t>(axis)].get<float>() == box.low[axis]);
            CHECK(accessor["max"][static_cast<std::size_t>(axis)].get<float>() == box.high[axis]);
        }
        const auto some = values_of(file, attributes["COLOR_0"]);
        colours.insert(colours.end(), some.begin(), some.end());
    }
    const std::vector<Rgb> colour_of_map = map_colours(partition);
    std::size_t vertex = 0;
    for (const ObjectId object : {1u, 2u})
        for (FaceId face = 0; face < scene.mesh.face_count(); ++face)
            for (int c = 0; c < 3 && scene.mesh.object_of_face[face] == object; ++c)
                REQUIRE(colours.at(vertex++) == colour_of_map[partition.map_of_face[face]]);
    CHECK(vertex == colours.size());
}
