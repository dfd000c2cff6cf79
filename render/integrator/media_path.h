#pragma once

#include "render/integrator/path_steps.h"

namespace hipmap {

/// `trace_path` through the media of a scene, which must have some: distances to scatterings are
/// drawn, and at each the lights are sampled as at a surface.  docs/media.md (6).
Rgb trace_media_path(const RenderScene& scene, const Ray& ray, RandomSequence& random,
                     const LightClasses& light);

} // namespace hipmap
