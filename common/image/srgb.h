#pragma once

#include <cmath>
#include <cstdint>

namespace hipmap {

/// Applies the sRGB transfer function: display-linear in [0, 1] to display value in [0, 1]. Source:
/// IEC 61966-2-1.
inline float srgb_from_linear(float linear)
{
    return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1 / 2.4f) - 0.055f;
}

/// Returns the nearest of 256 levels of a display value, clipped to [0, 1].  NaN gives 0.
inline std::uint8_t level_of(float display_value)
{
    if (!(display_value > 0))
        return 0;
    return display_value < 1 ? static_cast<std::uint8_t>(display_value * 255 + 0.5f) : 255;
}

} // namespace hipmap
