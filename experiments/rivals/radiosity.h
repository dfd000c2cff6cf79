#pragma once

#include "experiments/rivals/rival.h"

namespace hipmap {

/// Renders by finite-element radiosity with progressive refinement (Cohen et al. 1988): the cell
/// with the most unshot power shoots it, with form factors by rays.  All light at diffuse surfaces
/// comes from the cells, direct light too; other surfaces take what reaches them, and only eye rays
/// are followed over them.  The scene has no media, no copies and no environment.
RivalImage render_radiosity(const RenderScene& scene, const RivalSettings& settings);

} // namespace hipmap
