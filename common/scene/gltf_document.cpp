#include "common/scene/gltf_document.h"

#include "common/file/output_file.h"
#include "common/scene/raw_scene.h"

#include <cstdint>
#include <cstring>
#include <limits>
#include <string_view>

namespace hipmap {

namespace {

using nlohmann::json;

/// glTF itself nests about ten levels; the rest is for extras.  Libraries recurse over them.
constexpr int kDeepestJson = 200;
constexpr std::size_t kGlbHeader = 20; // file header and the header of the JSON chunk
constexpr std::size_t kGlbChunkHeader = 8;
constexpr std::uint32_t kJsonChunk = 0x4e4f534a;
constexpr std::uint32_t kBinChunk = 0x004e4942;

std::uint32_t little_endian_at(const std::vector<std::byte>& bytes, std::size_t offset)
{
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i)
        value |= std::to_integer<std::uint32_t>(bytes[offset + i]) << (8 * i);
    return value;
}

/// The JSON chunk of a GLB container (glTF 2.0, section 4.4).
std::string_view glb_json(const GltfDocument& document)
{
    const std::vector<std::byte>& bytes = document.bytes;
    const auto fail = [&](const char* what) {
        return scene_error(document.path, "GLB container", what);
    };
    if (bytes.size() < kGlbHeader)
        throw fail("the file is truncated; export it again");
    if (std::memcmp(bytes.data(), "glTF", 4) != 0)
        throw fail("does not begin with 'glTF', so it is not a .glb file; export it again");
    if (little_endian_at(bytes, 4) != 2)
        throw fail("not version 2; export as glTF 2.0");
    if (little_endian_at(bytes, 8) > bytes.size())
        throw fail("the file is shorter than its header says; export it again");
    const std::uint32_t length = little_endian_at(bytes, 12);
    if (little_endian_at(bytes, 16) != kJsonChunk)
        throw fail("the first chunk is not JSON; export it again");
    if (length > bytes.size() - kGlbHeader)
        throw fail("the JSON chunk runs past the end of the file; export it again");
    return {reinterpret_cast<const char*>(bytes.data()) + kGlbHeader, length};
}

/// Finds the BIN chunk, which comes right after that of JSON or not at all.
void find_glb_bin(GltfDocument& document, std::size_t json_size)
{
    const std::vector<std::byte>& bytes = document.bytes;
    const std::size_t at = kGlbHeader + json_size;
    if (bytes.size() - at < kGlbChunkHeader || little_endian_at(bytes, at + 4) != kBinChunk)
        return;
    document.bin_offset = at + kGlbChunkHeader;
    document.bin_size = little_endian_at(bytes, at);
    if (document.bin_size > bytes.size() - document.bin_offset)
        throw scene_error(document.path, "GLB container",
                          "the BIN chunk runs past the end of the file; export it again");
}

json parse_json(const std::filesystem::path& path, std::string_view text)
{
    const auto limit_depth = [&](int depth, json::parse_event_t, json&) {
        if (depth > kDeepestJson)
            throw scene_error(path, "JSON", "nested too deeply; remove the nested extras");
        return true;
    };
    try {
        return json::parse(text.begin(), text.end(), limit_depth);
    } catch (const json::parse_error& error) {
        throw scene_error(path, "JSON",
                          "damaged at byte " + std::to_string(error.byte) + "; export it again");
    } catch (const json::exception&) {
        throw scene_error(path, "JSON", "a number is too large; export it again");
    }
}

void check_version(const GltfDocument& document)
{
    const json& root = document.json;
    const char* const cure = "not a glTF 2.0 file; export as glTF 2.0";
    if (!root.is_object() || !root.contains("asset") || !root["asset"].is_object())
        throw scene_error(document.path, "asset", cure);
    const json& asset = root["asset"];
    for (const char* key : {"version", "minVersion"}) {
        if (!asset.contains(key) && std::string_view(key) == "minVersion")
            continue;
        if (!asset.contains(key) || !asset[key].is_string() ||
            !asset[key].get_ref<const std::string&>().starts_with("2."))
            throw scene_error(document.path, std::string("asset.") + key, cure);
    }
}

} // namespace

GltfDocument read_gltf_document(const std::filesystem::path& path)
{
    GltfDocument document;
    document.path = path;
    document.bytes = read_file(path);
    if (document.bytes.size() > std::numeric_limits<std::uint32_t>::max())
        throw scene_error(path, "", "larger than 4 GiB; export the buffers to separate files");
    document.binary =
        path.extension() == ".glb" || path.extension() == ".GLB" ||
        (document.bytes.size() >= 4 && std::memcmp(document.bytes.data(), "glTF", 4) == 0);
    const std::string_view text =
        document.binary ? glb_json(document)
                        : std::string_view(reinterpret_cast<const char*>(document.bytes.data()),
                                           document.bytes.size());
    if (document.binary)
        find_glb_bin(document, text.size());
    document.json = parse_json(path, text);
    check_version(document);
    check_gltf_schema(document);
    return document;
}

std::string generator_of(const GltfDocument& document)
{
    const json& asset = document.json.at("asset");
    const auto generator = asset.find("generator");
    return generator != asset.end() && generator->is_string() ? generator->get<std::string>() : "";
}

} // namespace hipmap
