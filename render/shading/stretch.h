#pragma once

#include "common/rays/surface_point.h"
#include "common/scene/scene.h"

#include <optional>

namespace hipmap {

/// The direction on the surface along which a material's reflections are stretched
/// (KHR_materials_anisotropy): that of its picture if it has one, else the tangent, turned by its
/// rotation.  Unit, across the shading normal; none where the mesh has no tangents and no picture
/// could lie.  Thread-safe.  Cost: a texture read.
std::optional<glm::vec3> stretched_along(const Scene& scene, const SurfacePoint& point,
                                         const glm::vec2& barycentric);

} // namespace hipmap
