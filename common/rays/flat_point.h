#pragma once

#include "common/rays/surface_point.h"

namespace hipmap {

/// Computes a point of a face as `surface_point` does, but takes the geometric normal as the
/// shading normal, which needs less time.  For points that no surface is shaded at, as those of
/// lights.
SurfacePoint flat_point(const TriangleMesh& mesh, FaceId face, const glm::vec2& barycentric);

} // namespace hipmap
