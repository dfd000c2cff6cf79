#pragma once

#include "common/image/image.h"
#include "common/image/image_format.h"

#include <filesystem>
#include <functional>
#include <span>

namespace hipmap {

/// Maps pixels from linear Rec. 709 to display values, in place.  Any number of threads at once.
using DisplayView = std::function<void(std::span<Rgb>)>;

/// Display settings of the 8-bit formats.
struct Display {
    float exposure_ev = 0.0f; ///< stops: the image is multiplied by 2^exposure_ev
    DisplayView view = {};    ///< after the exposure; empty: the sRGB transfer function
};

/// Writes `image` in the format of the suffix of `path`, whole or not at all (write_file). .exr,
/// .pfm, .hdr: linear, never exposed (.hdr: three 8-bit mantissas and one exponent, rounded towards
/// zero, so up to 1 part in 128 of the largest channel low; negative values are 0). .png, .ppm:
/// exposed, clipped to [0, 1], sRGB transfer function or Display::view, rounded, not dithered. A
/// channel that is not finite is written as 0. Throws InputError: unknown suffix, file not
/// writable, image too large for its format.
void write_image(const std::filesystem::path& path, const Image& image, const Display& display);

/// Writes an image whose pixels are already display values in [0, 1], clipped, as 8-bit .png.
/// Throws InputError if the file cannot be written.
void write_display_png(const std::filesystem::path& path, const Image& picture);

} // namespace hipmap
