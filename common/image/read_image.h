#pragma once

#include "common/image/image.h"

#include <filesystem>

namespace hipmap {

/// Reads a linear image by suffix: .exr (channels R, G, B), .pfm (colour or grey, either byte
/// order) or .hdr (Radiance).  Throws InputError: no such file, another suffix, damaged, or a pixel
/// that is not finite (named).
Image read_image(const std::filesystem::path& path);

} // namespace hipmap
