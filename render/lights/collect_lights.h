#pragma once

#include "common/scene/scene.h"
#include "render/lights/light_set.h"

namespace hipmap {

/// What the lights of a scene borrow besides the scene.
struct LightSources {
    const SurfaceEmission& surfaces;
    const EnvironmentMap* environment_map = nullptr; ///< null or empty: none
    const MediaSet* media = nullptr;                 ///< null: none
};

/// The lights of a scene: its point lights, spot lights and suns, its area lights, one light for
/// each object with emissive faces, its environment and its emissive media.  A textured face is
/// selected by its mean radiance.  O(F).
LightSet collect_lights(const Scene& scene, const LightSources& sources);

} // namespace hipmap
