#pragma once

#include <filesystem>

namespace hipmap {

/// exr, pfm and hdr hold radiance; png and ppm 8-bit display values.
enum class ImageFormat { exr, pfm, hdr, png, ppm };

/// Returns the format that the suffix of `path` names, in lower or upper case.  Throws InputError,
/// listing the known suffixes, on any other.
ImageFormat image_format(const std::filesystem::path& path);

} // namespace hipmap
