// Writes a wall of cards with a texture each as a .glb file, to measure what many large textures
// cost.
//
//     textured_scene TEXTURES SIDE OUT.glb
//
// The pixels of eight textures are in the file; the others show them again, but are textures of
// their own to whoever reads it.

#include "common/command_line/command_line.h"
#include "common/file/output_file.h"
#include "common/math/random.h"

#include <glm/glm.hpp>
#include <nlohmann/json.hpp>
#include <stb/stb_image_write.h>

#include <array>
#include <cmath>
#include <span>
#include <string>
#include <vector>

namespace hipmap {

namespace {

using nlohmann::json;

constexpr int kDistinct = 8, kQuality = 90;
/// A card, and its corners' texture coordinates: top left first, then row by row.
constexpr std::array<glm::vec3, 4> kCorners = {{{0, 1, 0}, {1, 1, 0}, {0, 0, 0}, {1, 0, 0}}};
constexpr std::array<glm::vec2, 4> kCoordinates = {{{0, 0}, {1, 0}, {0, 1}, {1, 1}}};
constexpr std::array<std::uint32_t, 6> kIndices = {0, 2, 3, 0, 3, 1};

/// Random numbers at the corners of squares of `size` pixels, interpolated between them.
float smooth_noise(int x, int y, int size, std::uint64_t seed)
{
    const auto corner = [&](int i, int j) {
        const auto place = static_cast<std::uint64_t>(j) << 32 | static_cast<std::uint64_t>(i);
        return static_cast<float>(mix_bits(seed ^ mix_bits(place)) >> 40) * 0x1p-24f;
    };
    const int i = x / size, j = y / size;
    const float u = static_cast<float>(x % size) / static_cast<float>(size);
    const float v = static_cast<float>(y % size) / static_cast<float>(size);
    return glm::mix(glm::mix(corner(i, j), corner(i + 1, j), u),
                    glm::mix(corner(i, j + 1), corner(i + 1, j + 1), u), v);
}

/// A JPEG file with large and small features, of a hue of its own.
std::string jpeg(int side, std::uint64_t seed)
{
    const glm::vec3 hue(smooth_noise(0, 0, 1, seed), smooth_noise(1, 0, 1, seed),
                        smooth_noise(2, 0, 1, seed));
    std::vector<std::uint8_t> rgb;
    rgb.reserve(3 * static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const float value = 0.6f * smooth_noise(x, y, 256, seed) +
                                0.3f * smooth_noise(x, y, 16, seed + 1) +
                                0.1f * smooth_noise(x, y, 2, seed + 2);
            for (int c = 0; c < 3; ++c)
                rgb.push_back(static_cast<std::uint8_t>(255 * value * (0.3f + 0.7f * hue[c])));
        }
    std::string out;
    const auto append = [](void* to, void* data, int size) {
        static_cast<std::string*>(to)->append(static_cast<const char*>(data),
                                              static_cast<std::size_t>(size));
    };
    stbi_write_jpg_to_func(append, &out, side, side, 3, rgb.data(), kQuality);
    return out;
}

/// What a file holds: its JSON, and the data that this refers to.
struct GltfFile {
    json root;
    std::string data;

    void add_view(std::span<const std::byte> bytes)
    {
        root["bufferViews"].push_back(
            {{"buffer", 0}, {"byteOffset", data.size()}, {"byteLength", bytes.size()}});
        data.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
        data.resize((data.size() + 3) / 4 * 4);
    }
};

void add_card(GltfFile& file)
{
    file.add_view(std::as_bytes(std::span(kCorners)));
    file.add_view(std::as_bytes(std::span(kCoordinates)));
    file.add_view(std::as_bytes(std::span(kIndices)));
    file.root["accessors"] = {
        {{"bufferView", 0},
         {"componentType", 5126},
         {"type", "VEC3"},
         {"count", 4},
         {"min", {0, 0, 0}},
         {"max", {1, 1, 0}}},
        {{"bufferView", 1}, {"componentType", 5126}, {"type", "VEC2"}, {"count", 4}},
        {{"bufferView", 2}, {"componentType", 5125}, {"type", "SCALAR"}, {"count", 6}}};
}

/// A card that wears the material.
void add_node(GltfFile& file, json node, const json& material)
{
    const std::size_t index = file.root["meshes"].size();
    file.root["materials"].push_back(material);
    file.root["meshes"].push_back({{"primitives",
                                    {{{"attributes", {{"POSITION", 0}, {"TEXCOORD_0", 1}}},
                                      {"indices", 2},
                                      {"material", index}}}}});
    node["mesh"] = index;
    file.root["nodes"].push_back(node);
}

void add_cards(GltfFile& file, int textures, int side)
{
    for (int i = 0; i < std::min(textures, kDistinct); ++i) {
        const std::string image = jpeg(side, static_cast<std::uint64_t>(i));
        file.add_view(std::as_bytes(std::span(image)));
    }
    const int across = static_cast<int>(std::ceil(std::sqrt(textures)));
    for (int i = 0; i < textures; ++i) {
        file.root["images"].push_back(
            {{"mimeType", "image/jpeg"}, {"bufferView", 3 + i % kDistinct}});
        file.root["textures"].push_back({{"source", i}});
        add_node(file, {{"translation", {i % across, i / across, 0}}},
                 {{"pbrMetallicRoughness",
                   {{"metallicFactor", 0}, {"baseColorTexture", {{"index", i}}}}}});
    }
}

GltfFile cards(int textures, int side)
{
    GltfFile file;
    file.root = {{"asset", {{"version", "2.0"}}}, {"scene", 0}};
    add_card(file);
    add_cards(file, textures, side);
    const double across = std::ceil(std::sqrt(textures));
    add_node(file,
             {{"translation", {0, across, across}},
              {"scale", {across, across, 1}},
              {"rotation", {1, 0, 0, 0}}},
             {{"emissiveFactor", {1, 1, 1}}, {"doubleSided", true}});
    file.root["cameras"] = {
        {{"type", "perspective"},
         {"perspective", {{"yfov", 0.9}, {"znear", 0.1}, {"aspectRatio", 1.5}}}}};
    file.root["nodes"].push_back(
        {{"camera", 0}, {"translation", {across / 2, across / 2, 0.99 * across}}});
    for (std::size_t i = 0; i < file.root["nodes"].size(); ++i)
        file.root["scenes"][0]["nodes"].push_back(i);
    file.root["buffers"] = {{{"byteLength", file.data.size()}}};
    return file;
}

int write_cards(int textures, int side, const std::filesystem::path& path)
{
    const GltfFile file = cards(textures, side);
    std::string text = file.root.dump();
    text.resize((text.size() + 3) / 4 * 4, ' ');
    const std::array<std::size_t, 5> head = {0x46546c67, 2, 28 + text.size() + file.data.size(),
                                             text.size(), 0x4e4f534a};
    const std::array<std::size_t, 2> middle = {file.data.size(), 0x004e4942};
    WholeFile out(path);
    const auto write_words = [&](std::span<const std::size_t> words) {
        const std::vector<std::uint32_t> narrow(words.begin(), words.end());
        out.write(std::as_bytes(std::span(narrow)));
    };
    write_words(head);
    out.write(std::as_bytes(std::span(text)));
    write_words(middle);
    out.write(std::as_bytes(std::span(file.data)));
    out.commit();
    return kExitDone;
}

} // namespace

} // namespace hipmap

int main(int argc, char** argv)
{
    return hipmap::run_tool([&] {
        int textures = 0, side = 0;
        std::filesystem::path path;
        CLI::App app("Writes a wall of cards with a texture each.", "textured_scene");
        app.add_option("TEXTURES", textures, "How many")
            ->required()
            ->check(hipmap::finite_in(1, 1e4));
        app.add_option("SIDE", side, "Their pixels across")
            ->required()
            ->check(hipmap::finite_in(1, 16384));
        app.add_option("OUT", path, "The .glb file")->required();
        if (const std::optional<int> code = hipmap::parse_arguments(app, argc, argv))
            return *code;
        return hipmap::write_cards(textures, side, path);
    });
}
