#pragma once

#include "common/math/rgb.h"
#include "common/scene/mesh.h"

namespace hipmap {

/// Light that a medium scattered, docs/media.md (7).
struct VolumePhoton {
    glm::vec3 position; ///< scene units
    Rgb power;          ///< that is scattered, W / metres_per_unit^2
    glm::vec3 travel;   ///< unit, the way it came
    MaterialId inside;  ///< whose inside scattered it; kNone: what is around
};

} // namespace hipmap
