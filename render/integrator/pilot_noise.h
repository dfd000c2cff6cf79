#pragma once

#include "common/image/image.h"
#include "render/integrator/light_sample_allocation.h"

#include <vector>

namespace hipmap {

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

/// The radiance of the pilot's images, with the seen lights.
struct PilotBrightness {
    std::vector<glm::dvec3> mean; ///< by pixel of these images
    double least2 = 0;            ///< the constant of docs/error.md (3)
};

/// width, height: of the image.  No pixel: none.
PilotBrightness brightness_of(const PilotNoise& pilot, int width, int height);

/// Returns the pixel of the pilot's images where pixel x, y of an image of width x height pixels
/// lies.
std::size_t pilot_pixel(const PilotNoise& pilot, int x, int y, int width, int height);

/// Returns the value, or black if it is not finite.
Rgb finite_or_black(const Rgb& value);

/// Returns means over the pixels of an image up to `reach` away along each axis.
std::vector<double> blurred(std::vector<double> values, int width, int reach);

/// Takes such means of each channel.
void blur(PilotBrightness& brightness, int width, int reach);

/// The share of the directions of long paths that is counted: some end on surfaces, or are not
/// taken.  docs/error.md (27).
inline constexpr double kReachedShare = 0.25;

/// Returns the variance of the light of long paths; zero if it is so rare that hardly any image
/// would have a sample of it.  docs/error.md (27).
double expected_variance(const LongPaths& paths);

} // namespace hipmap
