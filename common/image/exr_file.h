#pragma once

#include "common/image/image.h"

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

/// Writes `image` as channels R, G, B and each layer beside it: linear float, lossless.  Equal
/// images give equal bytes on any machine.  A channel that is not finite is written as 0.  Throws
/// InputError if the file cannot be written.
void write_exr(const std::filesystem::path& path, const Image& image,
               std::span<const Layer> layers);

/// Reads R, G, B (half or float) of the named layer of an .exr file, or of the main image if
/// `layer` is empty.  Throws InputError: no such file, not EXR, damaged, no such layer.
Image read_exr(const std::filesystem::path& path, std::string_view layer = {});

} // namespace hipmap
