#pragma once

#include "tests/support/tiny_scenes.h"

namespace hipmap::tiny {

/// Returns an orange dielectric over a diffuse base.
inline Material plastic(float roughness)
{
    Material material = diffuse({0.8f, 0.5f, 0.2f});
    material.specular = 1;
    material.roughness = roughness;
    return material;
}

} // namespace hipmap::tiny
