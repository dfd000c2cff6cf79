#include "common/input_error.h"
#include "common/math/random.h"
#include "tests/common/scene/sheet_file.h"

#include <catch2/catch.hpp>

namespace hipmap::tiny {

namespace {

/// Every corner of every face of `plain` is a corner of the loaded sheet, within `error`.
void check_same_sheet(const Scene& scene, const Sheet& plain, double error)
{
    REQUIRE(scene.mesh.face_count() == plain.indices.size() / 3);
    REQUIRE(scene.mesh.positions.size() == plain.positions.size() / 3);
    double area = 0.0;
    for (std::size_t i = 0; i < scene.mesh.positions.size(); ++i) {
        const glm::dvec3 p = world(scene, static_cast<std::uint32_t>(i));
        std::size_t nearest = 0;
        double distance = 10;
        for (std::size_t k = 0; k < plain.positions.size() / 3; ++k) {
            const glm::dvec3 q(plain.positions[3 * k], plain.positions[3 * k + 1],
                               plain.positions[3 * k + 2]);
            if (glm::length(p - q) < distance) {
                distance = glm::length(p - q);
                nearest = k;
            }
        }
        CHECK(distance < error);
        const glm::vec3 n(plain.normals[3 * nearest], plain.normals[3 * nearest + 1],
                          plain.normals[3 * nearest + 2]);
        CHECK(glm::dot(n, scene.mesh.normals[i]) > 0.9999f);
    }
    for (FaceId face = 0; face < scene.mesh.face_count(); ++face) {
        CHECK(scaled_normal(scene.mesh, face).z > 0);
        area += 0.5 * scaled_normal(scene.mesh, face).z;
    }
    CHECK(area * scene.frame.metres_per_unit * scene.frame.metres_per_unit ==
          Approx(1.0).epsilon(4 * error));
}

/// Loads or refuses with one line; whether it loads.
bool loads(const GltfFile& file)
{
    try {
        load(file);
        return true;
    } catch (const InputError& error) {
        CHECK(std::string(error.what()).find('\n') == std::string::npos);
        return false;
    }
}

json& draco_extension(GltfFile& file)
{
    return file.root["meshes"][0]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"];
}

json& meshopt_extension(GltfFile& file, std::size_t view)
{
    return file.root["bufferViews"][view]["extensions"]["EXT_meshopt_compression"];
}

} // namespace

TEST_CASE("Draco meshes equal plain ones up to quantisation", "[scene][gltf][compressed]")
{
    const Sheet sheet = bumpy_sheet();
    check_same_sheet(load(plain_file(sheet)).scene, sheet, 1e-6);
    check_same_sheet(load(draco_file(sheet, draco::MESH_SEQUENTIAL_ENCODING)).scene, sheet, 2e-4);
    check_same_sheet(load(draco_file(sheet, draco::MESH_EDGEBREAKER_ENCODING)).scene, sheet, 2e-4);
}

TEST_CASE("meshopt views equal plain ones up to quantisation", "[scene][gltf][compressed]")
{
    const Sheet sheet = bumpy_sheet();
    check_same_sheet(load(meshopt_file(sheet, "TRIANGLES")).scene, sheet, 1e-5);
    check_same_sheet(load(meshopt_file(sheet, "INDICES")).scene, sheet, 1e-5);
}

TEST_CASE("meshopt's fallback buffer needs neither uri nor flag", "[scene][gltf][compressed]")
{
    const Sheet sheet = bumpy_sheet();
    GltfFile file = meshopt_file(sheet, "TRIANGLES");
    file.root["buffers"][1].erase("extensions");
    check_same_sheet(load(file).scene, sheet, 1e-5);
    GltfFile plain = meshopt_file(sheet, "TRIANGLES");
    plain.root["buffers"][1].erase("extensions");
    plain.root["bufferViews"][2].erase("extensions"); // of the buffer without data
    CHECK_THROWS_WITH(load(plain), Catch::Contains("buffers[1]: has neither uri nor data"));
}

TEST_CASE("plain data beside Draco's is taken as it is", "[scene][gltf][compressed]")
{
    const Sheet sheet = bumpy_sheet();
    GltfFile file = plain_file(sheet);
    file.root["meshes"][0]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"] = {
        {"bufferView", 0}, {"attributes", {{"POSITION", 0}}}}; // not Draco data at all
    check_same_sheet(load(file).scene, sheet, 1e-6);
}

TEST_CASE("primitives that share Draco data each get their faces", "[scene][gltf][compressed]")
{
    GltfFile file = draco_file(bumpy_sheet(), draco::MESH_EDGEBREAKER_ENCODING);
    json& primitives = file.root["meshes"][0]["primitives"];
    primitives.push_back(primitives[0]);
    CHECK(load(file).scene.mesh.face_count() == 4 * kSide * kSide);
}

TEST_CASE("Draco data that is not what its accessors say is refused", "[scene][gltf][compressed]")
{
    const GltfFile good = draco_file(bumpy_sheet(), draco::MESH_EDGEBREAKER_ENCODING);
    GltfFile file = good;
    file.root["accessors"][0]["count"] = 80;
    CHECK_THROWS_WITH(load(file), Catch::Contains("81 vertices"));
    file = good;
    file.root["accessors"][2]["count"] = 3;
    CHECK_THROWS_WITH(load(file), Catch::Contains("384 corners"));
    file = good;
    draco_extension(file)["attributes"]["NORMAL"] = 77;
    CHECK_THROWS_WITH(load(file), Catch::Contains("no attribute 77"));
    file = good;
    file.root["accessors"][1]["type"] = "VEC2";
    CHECK_THROWS_WITH(load(file), Catch::Contains("not of the type"));
    file = good;
    draco_extension(file)["bufferView"] = 9;
    CHECK_THROWS_WITH(load(file), Catch::Contains("KHR_draco_mesh_compression.bufferView"));
}

TEST_CASE("a Draco header that promises 2^31 faces or points is refused before they are stored",
          "[scene][gltf][compressed]")
{
    const auto file_of = [](std::string bytes) {
        GltfFile file = empty_sheet_file(bumpy_sheet());
        const int view = add_view(file, bytes.data(), bytes.size());
        file.root["accessors"][2]["count"] = std::uint64_t{3} << 31;
        file.root["meshes"][0]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"] = {
            {"bufferView", view}, {"attributes", {{"POSITION", 0}}}};
        return file;
    };
    const std::string huge = "\x80\x80\x80\x80\x08"; // 2^31 as a varint
    for (const char method : {0, 1}) {
        std::string bytes("DRACO\x02\x02\x01", 8);
        bytes += std::string({method, 0, 0});
        if (method == 1)
            bytes += '\0'; // plain traversal
        bytes += huge + huge + std::string(20, '\0');
        CHECK_THROWS_WITH(load(file_of(bytes)), Catch::Contains("cannot be decoded"));
    }
}

TEST_CASE("meshopt views that promise more than they hold are refused", "[scene][gltf][compressed]")
{
    const GltfFile good = meshopt_file(bumpy_sheet(), "TRIANGLES");
    for (const std::size_t view : {0, 2}) {
        GltfFile file = good;
        const auto stride = meshopt_extension(file, view)["byteStride"].get<std::uint64_t>();
        const std::uint64_t count = 3'000'000'000'000;
        meshopt_extension(file, view)["count"] = count;
        file.root["bufferViews"][view]["byteOffset"] = 0;
        file.root["bufferViews"][view]["byteLength"] = count * stride;
        file.root["buffers"][1]["byteLength"] = count * stride;
        CHECK_THROWS_WITH(load(file), Catch::Contains("more than its data can hold"));
    }
    GltfFile file = good;
    for (int i = 0; i < 100; ++i)
        file.root["bufferViews"].push_back(file.root["bufferViews"][0]);
    CHECK_THROWS_WITH(load(file), Catch::Contains("overlaps"));
    file = good;
    file.root["bufferViews"][0].erase("extensions");
    CHECK_THROWS_WITH(load(file), Catch::Contains("that the file lacks"));
    for (const auto& [key, value] : {std::pair<const char*, json>{"mode", "MAGIC"},
                                     {"filter", "MAGIC"},
                                     {"filter", "QUATERNION"},
                                     {"byteStride", 6},
                                     {"count", 80},
                                     {"byteLength", 1u << 30},
                                     {"buffer", 1}}) {
        file = good;
        meshopt_extension(file, 0)[key] = value;
        INFO(key << " " << value);
        CHECK_THROWS_WITH(load(file), Catch::Contains("bufferViews[0]"));
    }
}

TEST_CASE("compressed data with any bytes changed or cut is loaded or refused",
          "[scene][gltf][compressed]")
{
    const Sheet sheet = bumpy_sheet();
    RandomSequence random(5, RandomStream::pictures, 0, 0);
    const auto below = [&](std::size_t n) {
        return std::min(n - 1, static_cast<std::size_t>(random.next() * static_cast<float>(n)));
    };
    for (const GltfFile& good :
         {draco_file(sheet, draco::MESH_EDGEBREAKER_ENCODING),
          draco_file(sheet, draco::MESH_SEQUENTIAL_ENCODING), meshopt_file(sheet, "TRIANGLES")}) {
        std::size_t refused = 0;
        for (int round = 0; round < 700; ++round) {
            GltfFile file = good;
            for (std::size_t change = 0; change < 1 + below(3); ++change)
                file.bytes[below(file.bytes.size())] = static_cast<char>(below(256));
            if (round % 10 == 0)
                std::fill(file.bytes.begin() +
                              static_cast<std::ptrdiff_t>(below(file.bytes.size())),
                          file.bytes.end(), '\0');
            refused += loads(file) ? 0 : 1;
        }
        CHECK(refused > 10);
    }
}

} // namespace hipmap::tiny
