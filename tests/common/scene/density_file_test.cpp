#include "common/input_error.h"
#include "common/scene/density_file.h"
#include "common/scene/fingerprint.h"
#include "tests/common/scene/tiny_gltf_file.h"

#include <catch2/catch.hpp>

#include <cstring>
#include <limits>

namespace hipmap::tiny {

namespace {

std::string bytes_of(std::uint32_t number)
{
    std::string out(sizeof number, '\0');
    std::memcpy(out.data(), &number, sizeof number);
    return out;
}

/// As Mitsuba 0.6 has it.
std::string volume(const glm::uvec3& nodes, const std::vector<float>& values,
                   std::uint32_t encoding = 1, std::uint32_t channels = 1)
{
    std::string out = "VOL\3" + bytes_of(encoding);
    for (int axis = 0; axis < 3; ++axis)
        out += bytes_of(nodes[axis]);
    out += bytes_of(channels) + std::string(24, '\7');
    return out.append(reinterpret_cast<const char*>(values.data()), 4 * values.size());
}

const std::vector<float> kValues = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 0};

GltfFile smoky()
{
    GltfFile file = tetrahedron_file();
    file.root["materials"][0]["extras"] = {
        {"hipmap", {{"medium", {{"scattering", {1, 1, 1}}, {"density", "smoke.vol"}}}}}};
    return file;
}

} // namespace

TEST_CASE("a grid of densities is read beside the scene", "[scene][gltf][extras]")
{
    const TemporaryFolder folder;
    write_text(folder / "smoke.vol", volume({3, 2, 2}, kValues));
    GltfFile file = smoky();
    file.root["scenes"][0]["extras"] = {{"hipmap", {{"medium", {{"density", "smoke.vol"}}}}}};
    write_text(folder / "scene.glb", file.glb());
    const Scene scene = load_scene(folder / "scene.glb", {}).scene;
    for (const DensityGrid* grid :
         {scene.materials.at(0).inside().density.get(), scene.around.density.get()}) {
        REQUIRE(grid != nullptr);
        CHECK(grid->nodes == glm::uvec3(3, 2, 2));
        CHECK(grid->values == kValues);
    }
    std::vector<float> others = kValues;
    others[5] = 0.5f;
    write_text(folder / "smoke.vol", volume({3, 2, 2}, others));
    const Scene other = load_scene(folder / "scene.glb", {}).scene;
    CHECK(fingerprint(other) == fingerprint(scene));
    CHECK_FALSE(content_fingerprint(other) == content_fingerprint(scene));
}

TEST_CASE("a damaged grid of densities is refused with its name", "[scene][damaged]")
{
    const TemporaryFolder folder;
    const auto refused = [&](const std::string& content, const char* what) {
        write_text(folder / "smoke.vol", content);
        CHECK_THROWS_WITH(read_density(folder / "smoke.vol"),
                          Catch::Contains("smoke.vol: ") && Catch::Contains(what));
    };
    const std::string good = volume({3, 2, 2}, kValues);
    refused("", "not a density grid");
    refused(good.substr(0, 47), "not a density grid");
    refused("PK" + good.substr(2), "not a density grid");
    refused(volume({3, 2, 2}, kValues, 3), "32-bit floats");
    refused(volume({3, 2, 2}, kValues, 1, 3), "one channel");
    refused(volume({12, 1, 1}, kValues), "along each axis");
    refused(volume({3, 2, 1u << 31}, kValues), "along each axis");
    refused(good + "x", "49 bytes of values, but 48");
    refused(volume({3, 2, 3}, kValues), "48 bytes of values, but 72");
    for (const float bad : {-1.0f, std::nanf(""), std::numeric_limits<float>::infinity()}) {
        std::vector<float> values = kValues;
        values[7] = bad;
        refused(volume({3, 2, 2}, values), "value 7");
    }
    write_text(folder / "scene.glb", smoky().glb());
    std::filesystem::remove(folder / "smoke.vol");
    CHECK_THROWS_WITH(load_scene(folder / "scene.glb", {}),
                      Catch::Contains("material 'paint'") && Catch::Contains("smoke.vol"));
}

} // namespace hipmap::tiny
