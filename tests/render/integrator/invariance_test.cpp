#include "tests/support/hard_surfaces.h"
#include "tests/support/placed_mesh.h"
#include "tests/support/render_image.h"
#include "tests/support/statistics.h"
#include "tests/support/tiny_scenes.h"

#include <catch2/catch.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <array>

using namespace hipmap;

namespace {

constexpr int kSize = 32;   ///< pixels a side
constexpr int kBlocks = 4;  ///< a side, whose means are compared
constexpr int kImages = 12; ///< of a scene, by different seeds

/// The bundled scene with a mirror, coloured glass and an emissive mesh, or with a light instead.
tiny::GltfFile cornell(bool light)
{
    tiny::GltfFile file =
        tiny::read_glb(std::filesystem::path(HIPMAP_SOURCE_DIR) / "assets/cornell.glb");
    for (tiny::json& material : file.root["materials"]) {
        if (material["name"] == "Glass")
            material["extensions"]["KHR_materials_volume"] = {
                {"thicknessFactor", 1},
                {"attenuationDistance", 0.5},
                {"attenuationColor", {0.3, 0.8, 0.9}}};
        if (light)
            material.erase("emissiveFactor");
    }
    if (light) {
        file.root["extensions"]["KHR_lights_punctual"]["lights"] = {
            {{"type", "point"}, {"intensity", 683 * 3}}};
        file.root["extensionsUsed"].push_back("KHR_lights_punctual");
        file.root["scenes"][0]["nodes"].push_back(file.root["nodes"].size());
        file.root["nodes"].push_back({{"translation", {0, 1.9, 0}},
                                      {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
    }
    return file;
}

/// Puts the scene elsewhere and makes it `scale` times as large.  What has lengths of its own in
/// glTF, which nodes do not change, is scaled with it: clip planes and depths of colour; a light of
/// so much W/sr lights a scene twice as large a quarter as much.
tiny::GltfFile placed(tiny::GltfFile file, const glm::dmat4& pose, double scale)
{
    tiny::hang_below(file, glm::scale(pose, glm::dvec3(scale)));
    tiny::json& lens = file.root["cameras"][0]["perspective"];
    for (const char* plane : {"znear", "zfar"})
        lens[plane] = lens[plane].get<double>() * scale;
    for (tiny::json& material : file.root["materials"])
        if (material.contains("/extensions/KHR_materials_volume"_json_pointer)) {
            tiny::json& depth =
                material["extensions"]["KHR_materials_volume"]["attenuationDistance"];
            depth = depth.get<double>() * scale;
        }
    if (file.root.contains("/extensions/KHR_lights_punctual"_json_pointer)) {
        tiny::json& power =
            file.root["extensions"]["KHR_lights_punctual"]["lights"][0]["intensity"];
        power = power.get<double>() * scale * scale;
    }
    return file;
}

tiny::GltfFile reordered(tiny::GltfFile file)
{
    tiny::json& nodes = file.root["scenes"][0]["nodes"];
    std::reverse(nodes.begin(), nodes.end());
    return file;
}

Image render_with(const RenderScene& scene, std::uint64_t seed)
{
    ImageOptions options;
    options.width = options.height = kSize;
    options.photons = 10000;
    options.dissertation.mode = MapMode::thesis;
    options.maps.neighbours = 30;
    options.dissertation.local_min = 300;
    options.seed = seed;
    return render_image(scene, options, {}).image;
}

/// Mean luminance of each block of pixels.
using Blocks = std::array<RunningMean, kBlocks * kBlocks>;

/// Over images with seeds from `first_seed` on.
Blocks blocks_of(const tiny::GltfFile& file, std::uint64_t first_seed)
{
    const auto ready = tiny::ready(tiny::load(file).scene);
    Blocks blocks;
    for (std::uint64_t seed = first_seed; seed < first_seed + kImages; ++seed) {
        const Image image = render_with(*ready->render, seed);
        std::array<double, kBlocks * kBlocks> sum{};
        for (int y = 0; y < kSize; ++y)
            for (int x = 0; x < kSize; ++x)
                sum[y * kBlocks / kSize * kBlocks + x * kBlocks / kSize] +=
                    luminance(image.pixels[y * kSize + x]);
        for (std::size_t block = 0; block < blocks.size(); ++block)
            blocks[block].add(sum[block] * kBlocks * kBlocks / (kSize * kSize));
    }
    return blocks;
}

/// The largest difference of any block, in its standard errors, after `a` is multiplied.
double largest_z(const Blocks& a, const Blocks& b, double factor = 1)
{
    double largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        largest = std::max(largest,
                           std::abs(factor * a[i].mean() - b[i].mean()) /
                               std::hypot(factor * a[i].standard_error(), b[i].standard_error()));
    return largest;
}

} // namespace

TEST_CASE("render: place, size, pose and the order of objects do not change the image",
          "[integrator]")
{
    const glm::dmat4 one(1.0);
    const glm::dmat4 moved = glm::translate(one, {1e6, -1e6, 1e6});
    const glm::dmat4 turned(glm::mat4_cast(glm::dquat(tiny::random_rotation(1))));
    for (const bool light : {false, true}) {
        const tiny::GltfFile file = cornell(light);
        const Blocks base = blocks_of(file, 0);
        const std::vector<std::pair<const char*, tiny::GltfFile>> others{
            {"moved", placed(file, moved, 1)},
            {"scaled by 1e-6", placed(file, one, 1e-6)},
            {"scaled by 1e6", placed(file, one, 1e6)},
            {"rotated", placed(file, turned, 1)},
            {"reordered", reordered(file)}};
        std::uint64_t seed = 1000;
        for (const auto& [name, other] : others) {
            INFO(name << (light ? ", lit by a lamp" : ", lit by a mesh"));
            CHECK(largest_z(blocks_of(other, seed += 1000), base) < kMostZ);
        }
        CHECK(largest_z(base, blocks_of(file, 500), 1.06) > kMostZ); // so much would show
    }
}

TEST_CASE("render: scaled by a power of two, the image is the same bit for bit", "[integrator]")
{
    for (const bool light : {false, true}) {
        const auto image_of = [](const tiny::GltfFile& file) {
            return render_with(*tiny::ready(tiny::load(file).scene)->render, 1);
        };
        const tiny::GltfFile file = cornell(light);
        const Image base = image_of(placed(file, glm::dmat4(1.0), 1));
        for (const double scale : {0x1p-20, 0.5, 0x1p20}) {
            INFO("scale " << scale << (light ? ", lit by a lamp" : ", lit by a mesh"));
            CHECK(image_of(placed(file, glm::dmat4(1.0), scale)).pixels == base.pixels);
        }
    }
}
