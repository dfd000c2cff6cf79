#pragma once

#include "common/math/rgb.h"

#include <cstdint>

namespace hipmap {

/// Returns colour `index` of an endless palette: neighbouring numbers are far apart, the first
/// kDistinctColours can be told apart by eye, and no two are equal.
Rgb palette_colour(std::uint32_t index);
inline constexpr std::uint32_t kDistinctColours = 24;

} // namespace hipmap
