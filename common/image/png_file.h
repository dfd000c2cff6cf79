#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace hipmap {

/// What an 8-bit picture looks like, which decides how it is best compressed.
enum class PictureKind {
    render,  ///< noise, whose strings of bytes do not repeat: only runs are searched for
    diagram, ///< areas of one colour
};

/// Returns the bytes of a PNG file of `width` x `height` pixels, both at least 1.  levels: red,
/// green and blue by pixel, rows from the top.  Throws std::bad_alloc.
std::vector<std::byte> encode_png(int width, int height, std::span<const std::uint8_t> levels,
                                  PictureKind kind);

} // namespace hipmap
