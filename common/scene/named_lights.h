#pragma once

#include "common/scene/scene_light.h"

#include <string>
#include <string_view>
#include <vector>

namespace hipmap {

/// A light that is no mesh, medium or environment, as messages and statistics describe it.
struct NamedLight {
    std::string_view kind; ///< "point light", "spot light", ...
    std::string name;
    bool emits = false;                ///< it has power
    bool has_size = false;             ///< its shadows are soft
    bool lacks_size = false;           ///< the file could give it a size and does not
    std::vector<glm::dvec3> placement; ///< positions, directions and lengths, scene units
};

/// Describes a light.
NamedLight describe_light(const SceneLight& light);

/// Describes all lights, grouped by kind; those of a kind keep their order.
std::vector<NamedLight> named_lights(const std::vector<SceneLight>& lights);

} // namespace hipmap
