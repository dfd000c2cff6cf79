#include "common/scene/decode_texture.h"

#include <stb/stb_image.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <string_view>

namespace hipmap {

namespace {

constexpr std::uint64_t kMostPixelsPerByte = 1032 * 8;

bool begins_with(std::span<const unsigned char> bytes, std::string_view start)
{
    return bytes.size() >= start.size() &&
           std::equal(start.begin(), start.end(), bytes.begin(),
                      [](char a, unsigned char b) { return static_cast<unsigned char>(a) == b; });
}

/// Whether a JPEG file has an end after its last scan begins; stb fills what is cut off with grey.
bool has_jpeg_end(std::span<const unsigned char> bytes)
{
    for (std::size_t i = bytes.size(); i-- > 1;) {
        if (bytes[i - 1] != 0xff)
            continue;
        if (bytes[i] == 0xd9)
            return true;
        if (bytes[i] == 0xda)
            return false;
    }
    return false;
}

} // namespace

DecodedTexture decode_texture(std::span<const unsigned char> bytes, std::uint64_t most_pixels)
{
    const bool jpeg = begins_with(bytes, "\xff\xd8\xff");
    if (!jpeg && !begins_with(bytes, "\x89PNG\r\n\x1a\n"))
        return {{}, "is neither PNG nor JPEG"};
    if (bytes.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()))
        return {{}, "is larger than 2 GB"};
    const int size = static_cast<int>(bytes.size());
    int width = 0, height = 0, channels = 0;
    if (stbi_info_from_memory(bytes.data(), size, &width, &height, &channels) == 0 || width < 1 ||
        height < 1)
        return {{}, "is damaged"};
    const auto pixels = static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height);
    if (pixels > most_pixels)
        return {{},
                "is too large (" + std::to_string(width) + " x " + std::to_string(height) + ")"};
    if (pixels / kMostPixelsPerByte > bytes.size() || (jpeg && !has_jpeg_end(bytes)))
        return {{}, "is truncated"};
    const std::unique_ptr<stbi_uc, void (*)(void*)> rgba(
        stbi_load_from_memory(bytes.data(), size, &width, &height, &channels, 4), stbi_image_free);
    if (!rgba)
        return {{}, "is damaged or truncated"};
    DecodedTexture texture;
    texture.image.width = width;
    texture.image.height = height;
    texture.image.rgba.assign(rgba.get(), rgba.get() + 4 * pixels);
    return texture;
}

} // namespace hipmap
