#pragma once

#include "render/integrator/render_options.h"

#include <cstdint>
#include <vector>

namespace hipmap {

/// Returns how many extra samples of directly visible lights each pixel takes in a pass,
/// [height][width], by docs/error.md (16); 0 where lights are not seen or fill the pixel evenly.
/// Empty: 0 everywhere. Depends on scene, seed, size and --samples alone.  On all threads; cost: 8
/// of these samples a pixel.
std::vector<std::uint16_t> allocate_light_samples(const RenderScene& scene,
                                                  const RenderOptions& options);

} // namespace hipmap
