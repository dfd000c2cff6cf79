#pragma once

#include "common/math/rgb.h"

#include <cstdint>

namespace hipmap {

/// Display-linear RGB of an OKLCH colour, brought into [0, 1] by lowering its chroma.
/// lightness: 0 to 1.  chroma: 0 (grey) to about 0.3.  hue_deg: any.
/// Source: Ottosson 2020, "A perceptual color space for image processing".
Rgb oklch(double lightness, double chroma, double hue_deg);

/// Colour number `index` of an endless palette: neighbouring numbers are far apart, the first
/// kDistinctColours are told apart by eye, and no two are equal.
Rgb palette_colour(std::uint32_t index);
inline constexpr std::uint32_t kDistinctColours = 24;

/// A scale from dark violet (0) to light yellow (1), of evenly rising lightness.  t is clipped.
Rgb scale_colour(double t);

} // namespace hipmap
