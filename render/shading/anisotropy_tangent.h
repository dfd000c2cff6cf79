#pragma once

#include "common/rays/surface_point.h"
#include "common/scene/scene.h"

#include <optional>

namespace hipmap {

/// Returns the direction on the surface along which a material's anisotropic reflections are widest
/// (KHR_materials_anisotropy): that of its texture if it has one, else the tangent, turned by its
/// rotation.  Unit, across the shading normal; none where the mesh has neither tangents nor texture
/// coordinates.  Thread-safe.  Cost: a texture read.
std::optional<glm::vec3> anisotropy_tangent(const Scene& scene, const SurfacePoint& point,
                                            const glm::vec2& barycentric);

} // namespace hipmap
