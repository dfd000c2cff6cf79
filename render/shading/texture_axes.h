#pragma once

#include "common/rays/surface_point.h"
#include "common/scene/scene.h"

#include <optional>

namespace hipmap {

/// Directions on the surface in which a texture runs to the right and upwards; unit, at right
/// angles to each other and to the shading normal.
struct TextureAxes {
    glm::vec3 right, up;
};

/// By the tangents of the file, else by how the texture lies on the face; none if it lies on a
/// line, or there are no texture coordinates.  Thread-safe.  docs/light_transport.md (23).
std::optional<TextureAxes> texture_axes(const TriangleMesh& mesh, const TextureSlot& slot,
                                        const SurfacePoint& point, const glm::vec2& barycentric);

/// The part of `direction` across `normal`, unit; none if it has none.
std::optional<glm::vec3> part_across(const glm::vec3& direction, const glm::vec3& normal);

} // namespace hipmap
