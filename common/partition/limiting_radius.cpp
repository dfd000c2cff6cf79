#include "common/partition/limiting_radius.h"

#include <algorithm>

namespace hipmap {

namespace {

/// Distances found in float are good to half of this.
constexpr double kDistanceRounding = 1e-6;

} // namespace

float exact_limiting_radius(const TriangleMesh& mesh, const Partition& partition, FaceId face,
                            const glm::vec3& point)
{
    double nearest = partition.self_distance[face];
    for (int corner = 0; corner < 3; ++corner) {
        if (!(partition.kept_edges[face] >> corner & 1))
            continue;
        // Faces count as behind a plane up to one error before it, and their photons lie up to
        // another before them.
        const double height = edge_plane(mesh, face, corner).height(glm::dvec3(point));
        nearest = std::min(nearest, height - 2.0 * double{partition.position_error});
    }
    return static_cast<float>(std::max(0.0, nearest * (1 - kDistanceRounding)));
}

glm::dvec3 face_centre(const TriangleMesh& mesh, FaceId face)
{
    const glm::uvec3 c = mesh.corners[face];
    return (glm::dvec3(mesh.positions[c.x]) + glm::dvec3(mesh.positions[c.y]) +
            glm::dvec3(mesh.positions[c.z])) /
           3.0;
}

float exact_group_radius(const TriangleMesh& mesh, const Partition& partition, FaceId face,
                         const glm::vec3& point)
{
    const double off = glm::distance(glm::dvec3(point), face_centre(mesh, face));
    const double radius = partition.group_radius[face] - off;
    return static_cast<float>(std::max(0.0, radius * (1 - kDistanceRounding)));
}

} // namespace hipmap
