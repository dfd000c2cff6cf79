#pragma once

#include "common/scene/scene.h"

#include <string>
#include <string_view>
#include <vector>

namespace hipmap {

/// What messages and statistics say of a light that is no mesh, medium or environment.
struct NamedLight {
    std::string_view kind; ///< "point light", "spot light", ...
    std::string name;
    bool emits = false;               ///< it has power
    bool has_size = false;            ///< its shadows are soft
    std::vector<glm::vec3> placement; ///< positions and directions, scene units
};

/// All of a scene, grouped by kind.  A kind of light that the scene gains is added here.
std::vector<NamedLight> named_lights(const Scene& scene);

} // namespace hipmap
