#pragma once

#include <array>
#include <cstdint>

namespace hipmap {

/// What a sample counts in the pixels around, docs/error.md (17).
enum class PixelFilter : std::uint8_t {
    box,      ///< in its own pixel alone
    b_spline, ///< quadratic B-spline: 3 pixels wide, standard deviation half a pixel
};

/// Weights of the pixel before, the pixel itself and the one behind along an axis; their sum is 1.
/// at: where the sample lies in its pixel, from 0 to 1.  Any thread; no loop.
inline std::array<float, 3> filter_weights(PixelFilter filter, float at)
{
    if (filter == PixelFilter::box)
        return {0, 1, 0};
    return {0.5f * (1 - at) * (1 - at), 0.5f + at * (1 - at), 0.5f * at * at};
}

} // namespace hipmap
