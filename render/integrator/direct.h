#pragma once

#include "render/integrator/coarse_image.h"
#include "render/integrator/pass_source.h"

namespace hipmap {

/// Makes the integrator that estimates from the photon maps at the first diffuse surface
/// (trace_eye_path).  Borrows and counts as make_pass_source does.
PassSource make_direct_source(const RenderScene& scene, const RenderOptions& options,
                              RenderStatistics& statistics, const PilotControl& pilots);

} // namespace hipmap
