#pragma once

#include "common/math/rgb.h"
#include "common/scene/mesh.h"

#include <cstdint>

namespace hipmap {

/// Light that arrived at a surface that gathers.
struct Photon {
    glm::vec3 position; ///< scene units
    Rgb power; ///< W / metres_per_unit^2, with what depends on its direction alone multiplied
               ///<   in: docs/photon_maps.md (1)
    glm::vec3 direction; ///< unit, towards where it came from
    FaceId face;
    std::uint8_t side; ///< 0 or 1, see Interaction
};

} // namespace hipmap
