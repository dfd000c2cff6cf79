#pragma once

#include "render/integrator/coarse_image.h"
#include "render/integrator/pass_source.h"

namespace hipmap {

/// Makes the progressive photon mapper with independent passes (Knaus and Zwicker 2011): each pass
/// traces photons, gathers along eye paths by `trace_gather_path`, and renders images by narrower
/// radii.  Borrows and counts as make_pass_source does; `render` alone uses the cache.  Renders the
/// pilot, which fixes the first radii: the same for the same scene and options.
PassSource make_progressive_source(const RenderScene& scene, const RenderOptions& options,
                                   RenderStatistics& statistics, PhotonCache* cache,
                                   const PilotControl& pilots);

} // namespace hipmap
