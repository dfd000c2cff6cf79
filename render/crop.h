#pragma once

#include "common/command_line/option_fields.h"
#include "common/image/pixel_rect.h"

#include <array>
#include <optional>

namespace hipmap {

/// An edge of a crop, from the left or the top of the whole image.
struct CropEdge {
    double at = 0;        ///< pixels or percent of the side
    bool percent = false; ///< of the width or height
};

/// The part of an image to render, as on the command line: edges X0, Y0, X1 and Y1.
struct Crop {
    std::array<CropEdge, 4> edges;
};

/// Makes a crop of pixels.
Crop crop_of(const PixelRect& pixels);

/// Makes an option field for a crop, "X0,Y0,X1,Y1".
OptionField crop_field(std::optional<Crop>& into);

/// Returns the pixels of a crop in an image of a size, percents rounded to the nearest pixel; empty
/// if these are all pixels.  Throws InputError if it has no pixel, or some outside the image.
PixelRect pixels_of(const Crop& crop, const PictureSize& whole);

} // namespace hipmap
