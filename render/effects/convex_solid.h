#pragma once

#include "common/partition/partition.h"
#include "common/scene/scene.h"

namespace hipmap {

/// Returns whether all faces together are one closed convex surface, up to the rounding of
/// positions.  Then no point of its outside lies in front of another.  No face: false.  Cost:
/// linear in the faces, one thread; less where an early face says no.
bool is_convex_solid(const TriangleMesh& mesh, const Partition& partition);

/// Returns whether all faces lie in front of the camera, and beyond its near clipping plane.
bool sees_from_outside(const Camera& camera, const TriangleMesh& mesh);

} // namespace hipmap
