#pragma once

#include <array>
#include <cstdint>

namespace hipmap {

/// The pixel reconstruction filter, docs/error.md (17).
enum class PixelFilter : std::uint8_t {
    box,      ///< a sample counts in its own pixel alone
    b_spline, ///< quadratic B-spline: 3 pixels wide, standard deviation half a pixel
};

/// Returns the weights of the previous pixel, the pixel itself and the next pixel along an axis;
/// their sum is 1. at: where the sample lies in its pixel, from 0 to 1.  Any thread; no loop.
inline std::array<float, 3> filter_weights(PixelFilter filter, float at)
{
    if (filter == PixelFilter::box)
        return {0, 1, 0};
    return {0.5f * (1 - at) * (1 - at), 0.5f + at * (1 - at), 0.5f * at * at};
}

} // namespace hipmap
