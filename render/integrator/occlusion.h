#pragma once

#include "render/integrator/coarse_image.h"
#include "render/integrator/pass_source.h"

namespace hipmap {

/// The distance beyond which nothing occludes, as a share of the diagonal of the scene's bounds,
/// unless RenderOptions::occlusion_distance says another.
inline constexpr float kOcclusionReach = 1.0f / 8;

/// Makes the integrator that shows ambient occlusion (Zhukov et al. 1998) as grey of the first face
/// along the eye ray: the share of its cosine-weighted hemisphere in which nothing lies within
/// reach; 0 where there is no face.  Materials (but for opacity), media and lights do not count.
/// Borrows and counts as make_pass_source does.
PassSource make_occlusion_source(const RenderScene& scene, const RenderOptions& options,
                                 RenderStatistics& statistics, const PilotControl& pilots);

} // namespace hipmap
