#pragma once

#include "common/math/rgb.h"

namespace hipmap {

/// Display-linear RGB of an OKLCH colour, brought into [0, 1] by lowering its chroma.
/// lightness: 0 to 1.  chroma: 0 (grey) to about 0.3.  hue_deg: any.
/// Source: Ottosson 2020, "A perceptual color space for image processing".
Rgb oklch(double lightness, double chroma, double hue_deg);

/// A scale from dark violet (0) to light yellow (1), of evenly rising lightness.  t is clipped.
Rgb scale_colour(double t);

} // namespace hipmap
