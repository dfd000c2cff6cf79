#pragma once

#include "common/math/rgb.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace hipmap {

/// An image of linear RGB pixels, rows from the top left.
struct Image {
    int width = 0;
    int height = 0;
    std::vector<Rgb> pixels; ///< [width * height]

    Image() = default;
    Image(int w, int h) : width(w), height(h), pixels(static_cast<std::size_t>(w) * h) {}

    Rgb& at(int x, int y) { return pixels[static_cast<std::size_t>(y) * width + x]; }
    const Rgb& at(int x, int y) const { return pixels[static_cast<std::size_t>(y) * width + x]; }
};

/// Returns whether an image file may have so many pixels: its header may promise anything.
inline bool is_plausible_size(std::int64_t width, std::int64_t height)
{
    constexpr std::int64_t kMost = std::int64_t{1} << 28;
    return width > 0 && height > 0 && width <= kMost && height <= kMost / width;
}

} // namespace hipmap
