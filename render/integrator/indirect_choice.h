#pragma once

#include "render/integrator/coarse_image.h"
#include "render/integrator/render_options.h"

namespace hipmap {

/// Chooses how an image finds indirect light: by the option, or by a pilot of paths over the image:
/// photons where they could be worth what they cost, docs/light_transport.md (50).  Never
/// automatic.  A function of scene and settings alone, whatever part of the image is rendered.
/// statistics: keeps the choice.  In parallel, each process of the team some rows.
IndirectLight choose_indirect(const RenderScene& scene, const RenderOptions& options,
                              const PilotControl& pilots, RenderStatistics& statistics);

} // namespace hipmap
