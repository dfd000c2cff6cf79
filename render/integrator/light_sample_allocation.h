#pragma once

#include "common/image/image.h"
#include "render/integrator/pilot_team.h"
#include "render/integrator/render_options.h"

#include <cstdint>
#include <vector>

namespace hipmap {

/// What one sample of the seen lights finds in each pixel, [height][width], by the brightest
/// channel: the mean and the variance, of the pixel and of those around it, as the samples of a
/// pixel alone may miss a light.  Empty: no light is seen, and none is expected by long paths.
struct LightNoise {
    std::vector<float> mean, variance;
    std::vector<LongPaths> long_paths; ///< what these samples may miss; empty: nothing
};

/// Returns the mean over the image; zero if no light is seen.
double mean_of(const LightNoise& noise);

/// Measures the lights that are seen (docs/error.md (16)).  Depends on scene, seed and size alone.
/// rivals: of a pass.  On all threads, each process of a team some rows; cost: 8 of these samples a
/// pixel.
LightNoise measure_light_noise(const RenderScene& scene, const RenderOptions& options,
                               const PilotTeam& team = {}, const GlossyRivals& rivals = {});

/// Measures the light of emissive faces: trace_emissive_difference of one ray of each pixel. Empty:
/// nothing emits.  Depends on scene, seed and size alone.  As parallel as measure_light_noise.
Image measure_emissive_noise(const RenderScene& scene, const RenderOptions& options,
                             const PilotTeam& team = {});

/// Returns how many samples of the seen lights each pixel takes besides its own in a pass, where
/// nothing else is known of the image: 16, or --samples if more, where they differ by more than a
/// twentieth of their mean (standard deviation); 0: none.
std::vector<std::uint16_t> allocate_light_samples(const LightNoise& noise, std::uint32_t samples);

} // namespace hipmap
