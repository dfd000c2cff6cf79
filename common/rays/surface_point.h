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

/// Computes a point of a face.  barycentric: weights of the second and third corner.
SurfacePoint surface_point(const TriangleMesh& mesh, FaceId face, const glm::vec2& barycentric);

/// Returns the origin of a ray that leaves `point` along `direction`, moved off the face by the
/// rounding bound of the position (not at all where the position is exact; a ray does not meet the
/// face it starts on).  Source: Pharr, Jakob and Humphreys 2023, section 6.8.6.
glm::vec3 offset_origin(const SurfacePoint& point, const glm::vec3& direction);

/// Returns a ray without end that leaves a point in a direction.  direction: unit.
inline Ray ray_from(const SurfacePoint& from, const glm::vec3& direction)
{
    Ray out;
    out.direction = direction;
    out.origin = offset_origin(from, direction);
    return out;
}

/// Returns a ray from one point towards another that stops short of it.
Ray ray_between(const SurfacePoint& from, const glm::vec3& to);

/// Returns a ray from one surface point to another that meets the faces of neither: it ends before
/// the second face by the rounding bound of that position.
Ray ray_between(const SurfacePoint& from, const SurfacePoint& to);

} // namespace hipmap
