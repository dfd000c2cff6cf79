#include "common/scene/gltf_buffers.h"

#include "common/file/output_file.h"
#include "common/scene/raw_scene.h"
#include "common/scene/scene_file.h"
#include "common/scene/scene_names.h"

#include <tiny_gltf.h>

#include <cstring>
#include <optional>
#include <utility>

namespace hipmap {

namespace {

using Bytes = std::vector<unsigned char>;

Bytes to_unsigned(std::span<const std::byte> bytes)
{
    const auto* const first = reinterpret_cast<const unsigned char*>(bytes.data());
    return Bytes(first, first + bytes.size());
}

/// The text of a percent-encoded URI; nothing if a code is broken or stands for NUL.
std::optional<std::string> decode_percent(const std::string& uri)
{
    const auto digit = [](char c) {
        const char* const digits = "0123456789abcdef";
        const char* const at = c == 0 ? nullptr : std::strchr(digits, c | 0x20);
        return at ? static_cast<int>(at - digits) : -1;
    };
    std::string text;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        char c = uri[i];
        if (c == '%') {
            const int high = i + 1 < uri.size() ? digit(uri[i + 1]) : -1;
            const int low = i + 2 < uri.size() ? digit(uri[i + 2]) : -1;
            if (high < 0 || low < 0)
                return std::nullopt;
            c = static_cast<char>(16 * high + low);
            i += 2;
        }
        if (c == 0)
            return std::nullopt;
        text += c;
    }
    return text;
}

constexpr const char* kMeshopt = "EXT_meshopt_compression";

bool says_fallback(const nlohmann::json& buffer)
{
    return has_extension(buffer, kMeshopt) &&
           buffer["extensions"][kMeshopt].value("fallback", false);
}

/// Returns whether a buffer is only a place for what meshopt decodes: all its bufferViews are
/// compressed.
bool has_compressed_views_only(const GltfDocument& document, std::size_t index)
{
    const auto views = document.json.find("bufferViews");
    if (views == document.json.end())
        return false;
    bool used = false;
    for (const nlohmann::json& view : *views) {
        if (view["buffer"].get<std::size_t>() != index)
            continue;
        if (!has_extension(view, kMeshopt))
            return false;
        used = true;
    }
    return used;
}

Bytes load_buffer(GltfDocument& document, std::size_t index)
{
    const nlohmann::json& buffer = document.json["buffers"][index];
    const std::string place = "buffers[" + std::to_string(index) + "]";
    const auto length = buffer["byteLength"].get<std::size_t>();
    Bytes bytes;
    if (buffer.contains("uri"))
        bytes = read_gltf_uri(document, place, buffer["uri"].get<std::string>());
    else if (says_fallback(buffer))
        return {};
    else if (index == 0 && document.binary)
        bytes = std::move(document.bin);
    else if (has_compressed_views_only(document, index))
        return {};
    else
        throw scene_error(document.path, place, "has neither uri nor data; export it again");
    if (bytes.size() < length)
        throw scene_error(document.path, place,
                          "its data is shorter than the scene says; export it again");
    bytes.resize(length);
    return bytes;
}

} // namespace

std::vector<unsigned char> read_gltf_uri(const GltfDocument& document, const std::string& place,
                                         const std::string& uri)
{
    const char* const cure = "its uri cannot be read; export the file again as .glb";
    Bytes bytes;
    if (uri.starts_with("data:")) {
        std::string kind;
        if (!tinygltf::IsDataURI(uri) ||
            !tinygltf::DecodeDataURI(&bytes, kind, uri, 0, /*checkSize=*/false))
            throw scene_error(document.path, place, cure);
        return bytes;
    }
    const std::optional<std::string> name = decode_percent(uri);
    if (!name)
        throw scene_error(document.path, place, cure);
    return to_unsigned(read_file(file_beside(document.path, place, *name)));
}

std::vector<std::vector<unsigned char>> load_gltf_buffers(GltfDocument& document)
{
    std::vector<Bytes> buffers;
    const auto listed = document.json.find("buffers");
    for (std::size_t i = 0; listed != document.json.end() && i < listed->size(); ++i)
        buffers.push_back(load_buffer(document, i));
    return buffers;
}

} // namespace hipmap
