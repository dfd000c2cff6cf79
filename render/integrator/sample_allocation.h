#pragma once

#include "common/image/image.h"

#include <cstdint>
#include <vector>

namespace hipmap {

/// The number of samples of each pixel in a pass, [height][width]; at least 1.  All passes of an
/// image share it: changing it by what passes show would bias both the mean and its error.
struct SampleAllocation {
    std::vector<std::uint16_t> samples; ///< empty: as many everywhere as the options say
    /// Extra samples of directly visible lights; 0: they are among the samples above.  Empty: 0
    /// everywhere.
    std::vector<std::uint16_t> lights;

    bool operator==(const SampleAllocation&) const = default;
};

/// Distributes `mean` samples a pixel over the image by docs/error.md (14).  first, second: images
/// of the same view and size, not necessarily width x height, by one sample a pixel each; pixels
/// that are not finite count as black.  Same images, same sample allocation.
SampleAllocation allocate_samples(const Image& first, const Image& second, int width, int height,
                                  std::uint32_t mean);

/// Returns a checksum of all counts; zero for an empty allocation.
std::uint64_t checksum(const SampleAllocation& allocation);

} // namespace hipmap
