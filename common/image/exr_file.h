#pragma once

#include "common/image/image.h"
#include "common/image/pixel_rect.h"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace hipmap {

/// An additional image of the same size in an .exr file.
struct Layer {
    std::string name; ///< its channels are name.R, name.G, name.B
    const Image* image = nullptr;
};

/// Writes `image` as channels R, G, B and each layer beside it: linear float, lossless, compressed
/// by all threads that oneTBB may use.  Equal images give equal bytes on any machine.  Writes 0 for
/// a value that is infinite or NaN.  place: which pixels of the whole image `image` and the layers
/// hold; they become the data window, and the whole image becomes the display window.  Throws
/// InputError if the file cannot be written.
void write_exr(const std::filesystem::path& path, const Image& image, std::span<const Layer> layers,
               const ImagePlace& place = {});

/// A channel of an .exr file: of each pixel, from the top left row by row, the float at
/// `first[pixel * stride]`.
struct ExrChannel {
    std::string name; ///< "ViewLayer.Depth.Z"
    const float* first = nullptr;
    std::size_t stride = 1;
};

/// The pixels that an .exr file holds.
struct ExrWindow {
    int width = 0;
    int height = 0;
    ImagePlace place = {};
};

/// Writes channels of the pixels of a window as one multi-layer .exr file, marked as Blender marks
/// its own: linear float, lossless.  A value that is not finite is written as 0.  Throws InputError
/// if the file cannot be written.
void write_exr_channels(const std::filesystem::path& path, const ExrWindow& window,
                        std::span<const ExrChannel> channels);

/// Reads R, G, B (half or float) of the named layer of an .exr file, or of the main image if
/// `layer` is empty.  Throws InputError: no such file, not EXR, damaged, no such layer.
Image read_exr(const std::filesystem::path& path, std::string_view layer = {});

} // namespace hipmap
