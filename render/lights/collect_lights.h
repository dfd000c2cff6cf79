#pragma once

#include "common/scene/scene.h"
#include "render/lights/light_set.h"

namespace hipmap {

/// The data that the lights of a scene borrow, besides the scene.
struct LightSources {
    const SurfaceEmission& surfaces;
    const EnvironmentMap* environment_map = nullptr; ///< null or empty: none
    const MediaSet* media = nullptr;                 ///< null: none
};

/// Collects the lights of a scene: point lights, spot lights and suns, area lights, one light for
/// each object with emissive faces, the environment and the emissive media.  A textured face is
/// selected by its mean radiance.  O(F).
LightSet collect_lights(const Scene& scene, const LightSources& sources);

} // namespace hipmap
