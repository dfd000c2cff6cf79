#pragma once

#include "common/image/image.h"

#include <filesystem>
#include <string>
#include <vector>

namespace hipmap {

/// A colour of an image and its meaning.
struct LegendEntry {
    std::vector<Rgb> colours; ///< display-linear; several make a scale from left to right
    std::string text;         ///< letters, digits and . , : - % ( ) / ; others become blank
};

/// Returns the image (display values) with the legend below it, in as many rows as it needs.
Image add_legend(const Image& picture, const std::vector<LegendEntry>& entries);

/// Returns a display-linear colour as "#rrggbb", clipped.
std::string hex_colour(const Rgb& linear);

/// An image in a file, with the legend of its colours.
struct LegendedPicture {
    std::filesystem::path path;
    int width = 0;
    int height = 0; ///< without the legend
    std::vector<LegendEntry> legend;
};

/// Writes the image (display values) with its legend below, as .png.  Throws InputError if the file
/// cannot be written.
LegendedPicture write_with_legend(const std::filesystem::path& path, const Image& picture,
                                  std::vector<LegendEntry> legend);

} // namespace hipmap
