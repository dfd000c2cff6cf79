#include "common/input_error.h"
#include "common/math/random.h"
#include "tests/common/scene/tiny_gltf_file.h"

#include <catch2/catch.hpp>

#include <limits>

namespace hipmap::tiny {

namespace {

/// Loads what a user may hand over; true if it loads, false if it is refused with one line.
bool loads(const std::string& name, const std::string& content)
{
    try {
        load_text(name, content);
        return true;
    } catch (const InputError& error) {
        CHECK(std::string(error.what()).find(name) != std::string::npos);
        CHECK(std::string(error.what()).find('\n') == std::string::npos);
        return false;
    }
}

void check_refused(const GltfFile& file, const std::string& place)
{
    CHECK_THROWS_WITH(load(file), Catch::Contains(place) && Catch::Contains("scene.glb"));
}

} // namespace

TEST_CASE("a GLB cut anywhere is refused", "[scene][gltf][damaged]")
{
    const std::string whole = tetrahedron_file().glb();
    REQUIRE(loads("scene.glb", whole));
    for (std::size_t size = 0; size < whole.size(); ++size)
        CHECK_FALSE(loads("scene.glb", whole.substr(0, size)));
}

TEST_CASE("a GLB with any bytes changed is loaded or refused", "[scene][gltf][damaged]")
{
    const std::string whole = tetrahedron_file().glb();
    RandomSequence random(3, RandomStream::pictures, 0, 0);
    const auto below = [&](std::size_t n) {
        return std::min(n - 1, static_cast<std::size_t>(random.next() * static_cast<float>(n)));
    };
    std::size_t refused = 0;
    for (int round = 0; round < 3000; ++round) {
        std::string damaged = whole;
        for (std::size_t change = 0; change < 1 + below(4); ++change)
            damaged[below(damaged.size())] = static_cast<char>(below(256));
        refused += loads("scene.glb", damaged) ? 0 : 1;
    }
    CHECK(refused > 100);
}

TEST_CASE("every number of a file replaced by every nasty one is loaded or refused",
          "[scene][gltf][damaged]")
{
    const GltfFile file = tetrahedron_file();
    const json flat = file.root.flatten();
    const std::vector<json> nasty = {-1,
                                     0,
                                     1,
                                     1e300,
                                     7e18,
                                     4294967296u,
                                     nullptr,
                                     "text",
                                     json::array(),
                                     json::object(),
                                     true,
                                     0.5,
                                     std::numeric_limits<std::uint64_t>::max()};
    for (const auto& [path, value] : flat.items())
        for (const json& replacement : nasty) {
            GltfFile damaged = file;
            damaged.root[json::json_pointer(path)] = replacement;
            INFO(path << " = " << replacement.dump());
            CHECK_NOTHROW(loads("scene.glb", damaged.glb()));
        }
}

TEST_CASE("references beyond their list are refused with their place", "[scene][gltf][damaged]")
{
    const struct {
        const char* path;
        const char* place;
    } references[] = {
        {"/meshes/0/primitives/0/attributes/POSITION",
         "meshes[0].primitives[0].attributes.POSITION"},
        {"/meshes/0/primitives/0/indices", "meshes[0].primitives[0].indices"},
        {"/meshes/0/primitives/0/material", "meshes[0].primitives[0].material"},
        {"/nodes/0/mesh", "nodes[0].mesh"},
        {"/nodes/0/camera", "nodes[0].camera"},
        {"/nodes/0/children/0", "nodes[0].children[0]"},
        {"/scenes/0/nodes/0", "scenes[0].nodes[0]"},
        {"/scene", "scene:"},
        {"/accessors/0/bufferView", "accessors[0].bufferView"},
        {"/bufferViews/0/buffer", "bufferViews[0].buffer"},
        {"/materials/0/normalTexture/index", "materials[0].normalTexture.index"},
        {"/nodes/0/extensions/KHR_lights_punctual/light", "KHR_lights_punctual.light"},
    };
    for (const auto& reference : references) {
        GltfFile file = tetrahedron_file();
        file.root[json::json_pointer(reference.path)] = 99;
        check_refused(file, reference.place);
    }
}

TEST_CASE("data beyond the buffer and indices beyond the vertices are refused",
          "[scene][gltf][damaged]")
{
    GltfFile file = tetrahedron_file();
    file.root["accessors"][0]["count"] = 5;
    check_refused(file, "accessors[0]");
    file = tetrahedron_file();
    file.root["accessors"][0]["byteOffset"] = std::uint64_t{1} << 52;
    check_refused(file, "accessors[0]");
    file = tetrahedron_file();
    file.root["bufferViews"][1]["byteLength"] = 1000;
    check_refused(file, "bufferViews[1]");
    file = tetrahedron_file();
    file.root["meshes"][0]["primitives"][0]["indices"] = file.add_indices({0, 1, 4});
    check_refused(file, "face 0: names vertex 4 of 4");
    file = tetrahedron_file();
    file.root["meshes"][0]["primitives"][0]["attributes"]["POSITION"] = file.add_vectors(
        {0, 0, 0, 1, 0, 0, 0, std::numeric_limits<float>::quiet_NaN(), 0, 0, 0, 1});
    check_refused(file, "vertex 2");
}

TEST_CASE("loops, two parents and transforms that are not affine are refused",
          "[scene][gltf][damaged]")
{
    GltfFile file = tetrahedron_file();
    file.root["nodes"][0]["children"] = {0};
    check_refused(file, "nodes[0]");
    file.root["nodes"] = {
        {{"children", {1, 2}}}, {{"children", {3}}}, {{"children", {3}}}, {{"mesh", 0}}};
    check_refused(file, "nodes[3]");
    file.root["nodes"] = {{{"mesh", 0}}, {{"children", {2}}}, {{"children", {1}}}};
    file.root.erase("scenes");
    file.root.erase("scene");
    check_refused(file, "loop");
    file = tetrahedron_file();
    file.root["nodes"][0]["matrix"] = {1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    check_refused(file, "nodes[0]");
    file = tetrahedron_file();
    file.root["nodes"][0]["scale"] = {1e308, 1, 1};
    file.root["nodes"].push_back({{"scale", {1e308, 1, 1}}, {"children", {0}}});
    file.root["scenes"][0]["nodes"] = {1};
    check_refused(file, "nodes[0]");
}

TEST_CASE("a deep chain of nodes loads and deep JSON is refused", "[scene][gltf][damaged]")
{
    GltfFile file = tetrahedron_file();
    constexpr std::size_t kDepth = 5000;
    file.root["nodes"] = json::array();
    for (std::size_t i = 0; i < kDepth; ++i)
        file.root["nodes"].push_back({{"translation", {0.001, 0, 0}}, {"children", {i + 1}}});
    file.root["nodes"].push_back({{"mesh", 0}});
    CHECK(load(file).scene.frame.centre.x == Approx(0.5 + 0.001 * kDepth));

    for (const std::size_t depth : {1000, 300000}) {
        const std::string open(depth, '['), close(depth, ']');
        CHECK_FALSE(
            loads("a.gltf", R"({"asset":{"version":"2.0"},"extras":)" + open + close + "}"));
        CHECK_FALSE(loads("a.gltf", R"({"asset":{"version":"2.0"},"extras":)" + open));
    }
}

TEST_CASE("unknown required extensions and other versions are refused by name",
          "[scene][gltf][damaged]")
{
    GltfFile file = tetrahedron_file();
    file.root["extensionsRequired"] = {"ACME_rounded_edges"};
    check_refused(file, "'ACME_rounded_edges'");
    file.root["extensionsRequired"] = {"KHR_meshopt_compression"};
    check_refused(file, "export without compression");
    file = tetrahedron_file();
    file.root["asset"]["version"] = "3.0";
    check_refused(file, "asset.version");
    file.root["asset"] = {{"version", "2.0"}, {"minVersion", "3.0"}};
    check_refused(file, "asset.minVersion");
}

TEST_CASE("buffers are opened beside the scene and nowhere else", "[scene][gltf][damaged]")
{
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / "inside");
    const GltfFile file = tetrahedron_file();
    write_text(folder / "data.bin", file.bytes);
    write_text(folder / "inside/data.bin", file.bytes);
    const auto load_with_uri = [&](const std::string& uri) {
        GltfFile separate = file;
        separate.root["buffers"] = {{{"byteLength", file.bytes.size()}, {"uri", uri}}};
        write_text(folder / "inside/scene.gltf", separate.text());
        return load_scene(folder / "inside/scene.gltf", {}).scene.mesh.face_count();
    };
    CHECK(load_with_uri("data.bin") == 4);
    CHECK(load_with_uri("./d%61ta.bin") == 4);
    for (const std::string& uri :
         {std::string("../data.bin"), std::string("%2e%2e/data.bin"), std::string("./../data.bin"),
          (folder / "data.bin").string(), "file://" + (folder / "data.bin").string(),
          std::string("http://127.0.0.1/data.bin"), std::string("..\\data.bin"),
          std::string("gone.bin"), std::string("."), std::string("data.bin%00"),
          std::string("data%2.bin"), std::string(100000, 'x'), std::string("/dev/zero"),
          std::string("data:application/octet-stream"), std::string()}) {
        INFO(uri.substr(0, 80));
        CHECK_THROWS_AS(load_with_uri(uri), InputError);
    }
}

TEST_CASE("files that are no scene are refused with a cure", "[scene][damaged]")
{
    const TemporaryFolder folder;
    CHECK_THROWS_WITH(load_scene(folder / "missing.glb", {}), Catch::Contains("no such file"));
    CHECK_THROWS_WITH(load_scene(folder.path(), {}), Catch::Contains("not a file"));
    write_text(folder / "scene.fbx", "x");
    CHECK_THROWS_WITH(load_scene(folder / "scene.fbx", {}), Catch::Contains(".glb"));
    CHECK_FALSE(loads("a.gltf", R"({"asset":{"version":"2.0"}})")); // nothing to do
    CHECK_FALSE(loads("a.gltf", "{\"asset\":{\"version\":\"2.0\"},\"x\":\"\xff\"}"));
    CHECK_FALSE(loads("a.gltf", R"({"asset":{"version":"2.0"},"scene":1e999})"));
}

} // namespace hipmap::tiny
