#pragma once

#include "common/image/image.h"
#include "render/integrator/light_sample_allocation.h"

#include <cstdint>
#include <vector>

namespace hipmap {

/// The number of samples of each pixel in a pass, [height][width]; at least 1.  All passes of an
/// image share it: changing it by what passes show would bias both the mean and its error.
struct SampleAllocation {
    std::vector<std::uint16_t> samples; ///< empty: as many everywhere as the options say
    /// Samples of the seen lights alone; 0: these are among the samples above.  Empty: 0
    /// everywhere.
    std::vector<std::uint16_t> lights;
    int emissive_points = 1; ///< that each sample takes on emissive faces, docs/error.md (26)

    bool operator==(const SampleAllocation&) const = default;
};

/// What pilots show of the noise of an image of width x height pixels.
struct PilotNoise {
    /// Images of the view without the seen lights, of the same size, not necessarily that of the
    /// image, by one sample a pixel each; pixels that are not finite count as black.
    const Image& first;
    const Image& second;
    const LightNoise& lights; ///< [height][width], or empty
    /// By measure_emissive_noise, of the size of `first`; null or empty: nothing is known.
    const Image* emissive = nullptr;
};

/// Distributes the work of `mean` samples a pixel over the image by docs/error.md (14), (16) and
/// (26).
/// Same pilots, same sample allocation.
SampleAllocation allocate_samples(const PilotNoise& pilot, int width, int height,
                                  std::uint32_t mean);

/// Returns the variance of a sample over the square of the brightness around, the mean over the
/// pixels.  first, second: images of the view, by one sample a pixel each; differences: of two
/// samples of each pixel, of the same size.  No pixel: zero.
double relative_variance(const Image& first, const Image& second, const Image& differences);

/// Returns a checksum of all counts; zero for an empty allocation.
std::uint64_t checksum(const SampleAllocation& allocation);

} // namespace hipmap
