#pragma once

#include "common/image/image.h"

namespace hipmap {

/// Exposure that shows most of `image` without clipping it, in EV (stops): the 90th percentile
/// (nearest rank) of the luminance of the pixels that are finite and brighter than black comes to
/// 0.5 of display-linear white.  0 if there is no such pixel.  Always finite; depends on the image
/// alone.  Linear in the pixels.
float auto_exposure(const Image& image);

} // namespace hipmap
