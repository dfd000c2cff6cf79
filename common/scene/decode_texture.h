#pragma once

#include "common/scene/texture.h"

#include <span>
#include <string>

namespace hipmap {

/// No texture may have more pixels, nor all textures of a scene kMostPixelsInAll.
inline constexpr std::uint64_t kMostPixels = std::uint64_t{1} << 28;
inline constexpr std::uint64_t kMostPixelsInAll = std::uint64_t{1} << 30;

/// A texture, or what is wrong with it.
struct DecodedTexture {
    TextureImage image;
    std::string problem; ///< empty: the texture is good
};

/// Decodes a PNG or JPEG file; 16 bits a channel become 8.  The size it promises is checked before
/// memory is taken: at most `most_pixels`, and 8256 pixels a byte (deflate turns a byte into 1032
/// at most, and a pixel takes one bit at least).
DecodedTexture decode_texture(std::span<const unsigned char> bytes, std::uint64_t most_pixels);

} // namespace hipmap
