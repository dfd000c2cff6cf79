#pragma once

#include "common/scene/scene.h"
#include "render/lights/environment_map.h"

namespace hipmap {

/// Reads the environment map that the scene names, .hdr, .exr or .pfm; empty if it names none.
/// turn_deg: about +y, counter-clockwise from above, beside the scene's own turn.  Throws
/// InputError: no such file, damaged, or a pixel that is below zero (named).
EnvironmentMap load_sky(const Scene& scene, double turn_deg);

} // namespace hipmap
