#pragma once

#include "common/image/image.h"

#include <filesystem>
#include <string>
#include <vector>

namespace hipmap {

/// A colour of a picture and what it stands for.
struct LegendEntry {
    std::vector<Rgb> colours; ///< display-linear; several make a scale from left to right
    std::string text;         ///< letters, digits and . , : - % ( ) / ; others become blank
};

/// The picture (display values) with the entries below it, in as many rows as they need.
Image add_legend(const Image& picture, const std::vector<LegendEntry>& entries);

/// "#rrggbb" of a display-linear colour, clipped.
std::string hex_colour(const Rgb& linear);

/// A picture in a file, and what its colours stand for.
struct LegendedPicture {
    std::filesystem::path path;
    int width = 0;
    int height = 0; ///< without the legend
    std::vector<LegendEntry> legend;
};

/// Writes the picture (display values) with its legend below, as .png.  Throws InputError if the
/// file cannot be written.
LegendedPicture write_with_legend(const std::filesystem::path& path, const Image& picture,
                                  std::vector<LegendEntry> legend);

} // namespace hipmap
