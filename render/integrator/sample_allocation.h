#pragma once

#include "render/integrator/pilot_noise.h"

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

/// Returns how many samples of a pass find the seen lights in a pixel.  evenly: those of each pixel
/// where nothing is allocated.
inline std::uint32_t samples_of_lights(const SampleAllocation& allocation, std::size_t pixel,
                                       std::uint32_t evenly)
{
    if (!allocation.lights.empty() && allocation.lights[pixel] > 0)
        return allocation.lights[pixel];
    return allocation.samples.empty() ? evenly : allocation.samples[pixel];
}

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
