#pragma once

#include "common/rays/embree_scene.h"
#include "preprocess/partition/face_tree.h"

namespace hipmap {

/// Returns the nearest face that a ray meets within [near, far], found in the tree that contacts
/// are found by: slower than Embree by the ray, but without the time and memory to build another
/// tree.  mesh: of the tree; without copies.  A ray may pass between faces that share an edge.
/// Thread-safe.
std::optional<RayHit> nearest_in_tree(const TriangleMesh& mesh, const FaceTree& tree,
                                      const Ray& ray);

} // namespace hipmap
