#pragma once

#include "common/scene/texture.h"

#include <span>
#include <string>

namespace hipmap {

/// The most pixels of one texture; all textures of a scene together may have kMostPixelsInAll.
inline constexpr std::uint64_t kMostPixels = std::uint64_t{1} << 28;
inline constexpr std::uint64_t kMostPixelsInAll = std::uint64_t{1} << 33;

/// A decoded texture, or the reason why it could not be decoded.
struct DecodedTexture {
    TextureImage image;
    std::string problem; ///< empty: the texture is good
};

/// Decodes a PNG or JPEG file; 16 bits a channel become 8.  The size in the header is checked
/// before memory is allocated: at most `most_pixels`, and 8256 pixels a byte (deflate turns a byte
/// into 1032 at most, and a pixel takes one bit at least).
DecodedTexture decode_texture(std::span<const unsigned char> bytes, std::uint64_t most_pixels);

} // namespace hipmap
