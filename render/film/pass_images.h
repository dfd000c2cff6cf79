#pragma once

#include "common/image/image.h"

#include <cmath>
#include <cstdint>
#include <vector>

namespace hipmap {

/// The factor from the radius of a pass to that of `PassImages::narrow`, and from that to
/// `narrower`.
inline constexpr double kNarrowing = 0.70710678118654752; // half the area each time

/// The result of one pass for each pixel: means of its samples, radiance, W/(m2 sr).
struct PassImages {
    Image radiance;
    Image narrow;                   ///< from the same photons within kNarrowing times the radii;
    Image narrower;                 ///< and within kNarrowing squared.  Both empty without radii.
    std::vector<std::uint8_t> kept; ///< [pixels] 0: no sample of the pixel was finite; its values
                                    ///<     do not count, whatever they are
    Image cut = {}; ///< what clamping took from the samples of `radiance`; empty: not clamped
};

/// Returns the radius in a pass (from 0) relative to that in pass 0, docs/error.md (1), 0 < alpha <
/// 1.  Any thread; no loop.
inline double radius_of_pass(std::uint64_t pass, double alpha)
{
    const auto i = static_cast<double>(pass);
    return std::exp(0.5 *
                    (std::lgamma(i + 1 + alpha) - std::lgamma(1 + alpha) - std::lgamma(i + 2)));
}

} // namespace hipmap
