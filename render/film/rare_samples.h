#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace hipmap {

/// A pixel with much noise, most of which one batch carries.
struct OutstandingPixel {
    std::size_t pixel = 0;
    std::uint64_t batch = 0; ///< that is above the others by most
    double noise = 0;        ///< that this batch carries, not below 0
    bool again = false;      ///< another batch has found the light too
};

/// Which rare bright samples are rare enough to be worth their removal, docs/error.md (25).
struct RareSamples {
    std::vector<std::uint8_t> removed; ///< [pixels given] 1: is of such a sample
    double missing = 0;                ///< relMSE of the light that is missing then, in the unit of
                                       ///<     OutstandingPixel::noise
    double most_missing = 0;           ///< 95 % upper limit of that

    bool operator==(const RareSamples&) const = default;
};

/// Finds out how often pixels are hit by samples as bright as each.  pixels: ascending.  width: of
/// the image, at least 1.  Near linear in the pixels, of which few are within two rows.
RareSamples judge_rare_samples(std::span<const OutstandingPixel> pixels, std::size_t width);

} // namespace hipmap
