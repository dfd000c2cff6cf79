#pragma once

#include "common/scene/scene.h"

#include <string>
#include <string_view>
#include <vector>

namespace hipmap {

/// A light that is no mesh, medium or environment, as messages and statistics describe it.
struct NamedLight {
    std::string_view kind; ///< "point light", "spot light", ...
    std::string name;
    bool emits = false;               ///< it has power
    bool has_size = false;            ///< its shadows are soft
    std::vector<glm::vec3> placement; ///< positions and directions, scene units
};

/// Returns all named lights of a scene, grouped by kind.  A new kind of light is added here.
std::vector<NamedLight> named_lights(const Scene& scene);

} // namespace hipmap
