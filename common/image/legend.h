#pragma once

#include "common/image/image.h"

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

} // namespace hipmap
