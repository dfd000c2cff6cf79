#pragma once

#include "common/rays/surface_point.h"
#include "common/scene/scene.h"

namespace hipmap {

/// Returns the shading normal at a point, tilted by the normal map of the face's material: unit, in
/// the hemisphere of the geometric normal; unchanged where there is no map.  The frame is that of
/// the file's tangents, or else of the texture on the face, docs/light_transport.md (23).  use: the
/// surface's map or that of its clear coat.  Thread-safe.
glm::vec3 mapped_normal(const Scene& scene, const SurfacePoint& point, const glm::vec2& barycentric,
                        TextureUse use = TextureUse::normal);

} // namespace hipmap
