#include "render/integrator/expect_light.h"

#include <algorithm>

namespace hipmap {

namespace {

/// Two samples of a pixel say little of its brightness: so do those of the pixels around it.
constexpr int kReach = 2;

/// The part of a sample's variance that is left in the nine pixels of the B-spline, docs/error.md
/// (17).
constexpr double kSpread = 11.0 / 20 * 11 / 20;

/// The moments of what one sample finds of the seen lights in a pixel.
struct LightMoments {
    double mean = 0, variance = 0;
};

LightMoments moments_of(const LightNoise& noise, std::size_t pixel)
{
    LightMoments out{noise.mean[pixel], noise.variance[pixel]};
    if (noise.long_paths.empty())
        return out;
    const LongPaths& paths = noise.long_paths[pixel];
    if (expected_variance(paths) > out.variance)
        out = {paths.mean, paths.variance};
    return out;
}

} // namespace

ExpectedLight expect_light(const PilotNoise& pilot, const RenderOptions& options,
                           const SampleAllocation& allocation)
{
    ExpectedLight out;
    if (pilot.lights.mean.empty())
        return out;
    PilotBrightness brightness = brightness_of(pilot, options.width, options.height);
    blur(brightness, pilot.first.width, kReach);
    const std::size_t pixels = pilot.lights.mean.size();
    const double spread = options.filter == PixelFilter::box ? 1 : kSpread;
    for (std::size_t i = 0; i < pixels; ++i) {
        const LightMoments light = moments_of(pilot.lights, i);
        const int x = static_cast<int>(i) % options.width, y = static_cast<int>(i) / options.width;
        const glm::dvec3& mean =
            brightness.mean[pilot_pixel(pilot, x, y, options.width, options.height)];
        // With the light itself, which may be missing around.
        const double value = std::max({mean.x, mean.y, mean.z, light.mean});
        const double scale2 = (value * value + brightness.least2) * static_cast<double>(pixels);
        const double samples = samples_of_lights(allocation, i, options.samples);
        const double mean2 = light.mean * light.mean;
        if (light.variance > 0 && scale2 > 0)
            add_light({spread * light.variance / (samples * scale2), mean2 / scale2,
                       samples * mean2 / light.variance},
                      out);
    }
    return out;
}

} // namespace hipmap
