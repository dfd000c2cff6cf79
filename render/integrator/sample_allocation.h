#pragma once

#include "common/image/image.h"

#include <cstdint>
#include <vector>

namespace hipmap {

/// Samples of each pixel in a pass, [height][width]; at least 1.  The same for all passes of an
/// image: were they revised by what passes show, neither its mean nor its error would be right.
struct SampleAllocation {
    std::vector<std::uint16_t> samples; ///< empty: as many everywhere as the options say
    /// Of lights that the eye sees, alone; 0: they are among the samples above.  Empty: 0
    /// everywhere.
    std::vector<std::uint16_t> lights;

    bool operator==(const SampleAllocation&) const = default;
};

/// Shares out `mean` samples a pixel by docs/error.md (14).  first, second: images of the same view
/// and size, not necessarily width x height, by one sample a pixel each; pixels that are not finite
/// count as black.  Same images, same allocation.
SampleAllocation allocate_samples(const Image& first, const Image& second, int width, int height,
                                  std::uint32_t mean);

/// Mixes all counts; zero of an empty allocation.
std::uint64_t checksum(const SampleAllocation& allocation);

} // namespace hipmap
