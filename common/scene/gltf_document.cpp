#include "common/scene/gltf_document.h"

#include "common/file/output_file.h"
#include "common/scene/raw_scene.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>
#include <string_view>

namespace hipmap {

namespace {

using nlohmann::json;

/// glTF itself nests about ten levels; the rest is for extras.  Libraries recurse over them.
constexpr int kDeepestJson = 200;
constexpr std::string_view kMagic = "glTF";
constexpr std::size_t kGlbHeader = 20; // file header and the header of the JSON chunk
constexpr std::size_t kGlbChunkHeader = 8;
constexpr std::uint32_t kJsonChunk = 0x4e4f534a;
constexpr std::uint32_t kBinChunk = 0x004e4942;

std::uint32_t little_endian_at(const std::vector<unsigned char>& bytes, std::size_t offset)
{
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i)
        value |= std::uint32_t{bytes[offset + i]} << (8 * i);
    return value;
}

/// The next bytes of a file, at most `count`.
std::vector<unsigned char> read_bytes(InputFile& file, std::size_t count)
{
    std::vector<unsigned char> bytes(std::min(count, file.left()));
    bytes.resize(file.read(std::as_writable_bytes(std::span(bytes))));
    return bytes;
}

/// The JSON chunk of a GLB container (glTF 2.0, section 4.4).  file: at its begin.
std::vector<unsigned char> read_glb_json(InputFile& file, const std::filesystem::path& path)
{
    const std::vector<unsigned char> header = read_bytes(file, kGlbHeader);
    const auto fail = [&](const char* what) { return scene_error(path, "GLB container", what); };
    if (header.size() < kGlbHeader)
        throw fail("the file is truncated; export it again");
    if (std::memcmp(header.data(), kMagic.data(), kMagic.size()) != 0)
        throw fail("does not begin with 'glTF', so it is not a .glb file; export it again");
    if (little_endian_at(header, 4) != 2)
        throw fail("not version 2; export as glTF 2.0");
    if (little_endian_at(header, 8) > file.size())
        throw fail("the file is shorter than its header says; export it again");
    const std::uint32_t length = little_endian_at(header, 12);
    if (little_endian_at(header, 16) != kJsonChunk)
        throw fail("the first chunk is not JSON; export it again");
    if (length > file.left())
        throw fail("the JSON chunk runs past the end of the file; export it again");
    return read_bytes(file, length);
}

/// The BIN chunk, which comes right after that of JSON or not at all.
std::vector<unsigned char> read_glb_bin(InputFile& file, const std::filesystem::path& path)
{
    const std::vector<unsigned char> header = read_bytes(file, kGlbChunkHeader);
    if (header.size() < kGlbChunkHeader || little_endian_at(header, 4) != kBinChunk)
        return {};
    if (little_endian_at(header, 0) > file.left())
        throw scene_error(path, "GLB container",
                          "the BIN chunk runs past the end of the file; export it again");
    return read_bytes(file, little_endian_at(header, 0));
}

/// Whether a file is a container, by its suffix or how it begins.  Goes back to its begin.
bool is_container(InputFile& file, const std::filesystem::path& path)
{
    const std::vector<unsigned char> begin = read_bytes(file, kMagic.size());
    file.seek(0);
    return path.extension() == ".glb" || path.extension() == ".GLB" ||
           (begin.size() == kMagic.size() &&
            std::memcmp(begin.data(), kMagic.data(), kMagic.size()) == 0);
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
    InputFile file(path);
    if (file.size() > std::numeric_limits<std::uint32_t>::max())
        throw scene_error(path, "", "larger than 4 GiB; export the buffers to separate files");
    document.binary = is_container(file, path);
    const std::vector<unsigned char> text =
        document.binary ? read_glb_json(file, path) : read_bytes(file, file.left());
    if (document.binary)
        document.bin = read_glb_bin(file, path);
    document.json = parse_json(path, {reinterpret_cast<const char*>(text.data()), text.size()});
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
