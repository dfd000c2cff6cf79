#pragma once

#include "common/rays/surface_point.h"
#include "common/scene/scene.h"

#include <optional>

namespace hipmap {

/// The directions on the surface in which a texture runs to the right and upwards; unit, at right
/// angles to each other and to the shading normal.
struct TextureAxes {
    glm::vec3 right, up;
};

/// Returns the axes of a texture, from the tangents of the file or else from its place on the face;
/// none if the texture is degenerate there, or there are no texture coordinates.  Thread-safe.
/// docs/light_transport.md (23).
std::optional<TextureAxes> texture_axes(const TriangleMesh& mesh, const TextureSlot& slot,
                                        const SurfacePoint& point, const glm::vec2& barycentric);

/// Returns the part of `direction` across `normal`, unit; none if there is none.
std::optional<glm::vec3> part_across(const glm::vec3& direction, const glm::vec3& normal);

} // namespace hipmap
