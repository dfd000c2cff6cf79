#pragma once

#include "common/rays/embree_scene.h"
#include "common/scene/mesh.h"

namespace hipmap {

/// A point of a face, computed from its corners and not from the ray.
struct SurfacePoint {
    FaceId face = kNone;
    glm::vec3 position{0.0f};         ///< scene units
    glm::vec3 position_error{0.0f};   ///< bound of its rounding, per axis
    glm::vec3 geometric_normal{0.0f}; ///< unit, towards the front of the face
    glm::vec3 shading_normal{0.0f};   ///< unit, in the hemisphere of the geometric normal
};

/// barycentric: weights of the second and third corner.
SurfacePoint surface_point(const TriangleMesh& mesh, FaceId face, const glm::vec2& barycentric);

/// Origin of a ray that leaves `point` along `direction`, moved off the face by the position's own
/// rounding bound (by nothing where the position is exact; a ray does not meet the face it starts
/// on).  Source: Pharr, Jakob and Humphreys 2023, section 6.8.6.
glm::vec3 offset_origin(const SurfacePoint& point, const glm::vec3& direction);

/// A ray from one point towards another that stops short of it.
Ray ray_between(const SurfacePoint& from, const glm::vec3& to);

/// A ray from one surface point to another that does not meet the faces of either: it ends off the
/// second face by that position's own rounding bound.
Ray ray_between(const SurfacePoint& from, const SurfacePoint& to);

} // namespace hipmap
