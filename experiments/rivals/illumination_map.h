#pragma once

#include "experiments/rivals/rival.h"

namespace hipmap {

/// Renders with illumination maps (Arvo 1986, "Backward Ray Tracing"): light paths add their power
/// to the cells of the surfaces that they meet, and eye rays look the irradiance up there.  Direct
/// light is found by shadow rays.  The scene has no media and no copies.
RivalImage render_illumination_map(const RenderScene& scene, const RivalSettings& settings);

} // namespace hipmap
