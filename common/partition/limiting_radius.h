#pragma once

#include "common/partition/partition.h"

#include <glm/glm.hpp>

namespace hipmap {

/// The plane through an edge of a face, perpendicular to the face.
struct EdgePlane {
    glm::dvec3 origin{0.0};
    glm::dvec3 inward{0.0}; ///< unit, in the face's plane; zero for a face without area

    /// Returns the distance of a point from the plane, positive on the side of the face.
    double height(const glm::dvec3& point) const { return glm::dot(point - origin, inward); }
};

/// Returns the plane through the edge that begins at `corner`, 0 to 2.  normal: scaled_normal of
/// the face.
inline EdgePlane edge_plane(const TriangleMesh& mesh, FaceId face, int corner,
                            const glm::dvec3& normal)
{
    const glm::uvec3 c = mesh.corners[face];
    EdgePlane plane{glm::dvec3(mesh.positions[c[corner]])};
    const glm::dvec3 along = glm::dvec3(mesh.positions[c[(corner + 1) % 3]]) - plane.origin;
    const glm::dvec3 inward = glm::cross(normal, along);
    if (const double length = glm::length(inward); length > 0)
        plane.inward = inward / length;
    return plane;
}

inline EdgePlane edge_plane(const TriangleMesh& mesh, FaceId face, int corner)
{
    return edge_plane(mesh, face, corner, scaled_normal(mesh, face));
}

/// Distance from a point of `face` within which its shared map has photons of this face alone:
///     r(x) = min(heights of x over the planes of the kept edges, self-distance)
/// docs/partition_file.md (4), less what the rounding of positions and of distances in float can
/// amount to.  A search of the face's photons that ends strictly within it finds what a search of
/// the whole shared map would find, photon for photon.
/// point: rounded to no farther than partition.position_error from the face.
/// Returns at least 0; infinity for a face alone in its map; 0 for a face without a map.
float exact_limiting_radius(const TriangleMesh& mesh, const Partition& partition, FaceId face,
                            const glm::vec3& point);

/// Returns the mean of the corners of a face, from which equation (5) measures the self-distance of
/// a face in a group.
glm::dvec3 face_centre(const TriangleMesh& mesh, FaceId face);

/// Distance from a point within which its shared map has photons of the face's group alone,
///     r_G(x) = D - |x - c|
/// docs/partition_file.md (5), less rounding, as exact_limiting_radius is.  point: any.
/// Returns at least 0; 0 for a face without a group.
float exact_group_radius(const TriangleMesh& mesh, const Partition& partition, FaceId face,
                         const glm::vec3& point);

} // namespace hipmap
