#pragma once

#include "common/scene/scene.h"

namespace hipmap {

/// The most faces that a line through media is followed across.
inline constexpr int kMostFaces = 4096;

/// Returns whether light enters closed meshes of the material and meets something there.  Paper and
/// leaves that hold nothing are thin, closed or not.
inline bool lets_light_in(const Material& material)
{
    return material.transmission > 0 || !material.boundary ||
           (material.diffuse_transmission > 0 && !material.inside().is_clear());
}

/// Returns whether the surface refracts light by an index of refraction.
inline bool is_dielectric(const Material& material)
{
    return material.boundary && material.transmission > 0;
}

} // namespace hipmap
