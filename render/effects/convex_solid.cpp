#include "render/effects/convex_solid.h"

#include <algorithm>
#include <limits>

namespace hipmap {

namespace {

/// Rounding moves a vertex and the plane that it is compared with.
constexpr double kErrors = 4;

/// Faces whose planes are compared with all vertices.
constexpr std::size_t kPlanes = 64;

/// Range of heights of points over planes.
struct Heights {
    double least = 0, most = 0;

    void add(double height)
    {
        least = std::min(least, height);
        most = std::max(most, height);
    }
    /// All points are on one side, but for `error`.
    bool are_on_one_side(double error) const { return most <= error || least >= -error; }
};

/// The plane of a face with an area, its normal as the connected surface is wound.
struct FacePlane {
    glm::dvec3 origin, normal;

    FacePlane(const TriangleMesh& mesh, const Partition& partition, FaceId face)
        : origin(mesh.positions[mesh.corners[face].x])
    {
        const glm::dvec3 up = glm::normalize(scaled_normal(mesh, face));
        normal = partition.is_flipped(face) ? -up : up;
    }
    double height(const glm::vec3& point) const
    {
        return glm::dot(normal, glm::dvec3(point) - origin);
    }
};

/// Adds the heights of the neighbours of a face; false: it has too few.
bool add_neighbours(const TriangleMesh& mesh, const Partition& partition, FaceId face,
                    Heights& heights)
{
    const FacePlane plane(mesh, partition, face);
    for (std::uint32_t edge = 3 * face; edge < 3 * face + 3; ++edge) {
        const std::uint32_t other = partition.opposite[edge];
        if (other == kNone)
            return false;
        const int off_edge = static_cast<int>((other % 3 + 2) % 3);
        heights.add(plane.height(mesh.positions[mesh.corners[other / 3][off_edge]]));
    }
    return true;
}

/// The number of faces that edges connect with the first.
std::size_t count_connected(const Partition& partition)
{
    std::vector<std::uint8_t> met(partition.face_count(), 0);
    std::vector<FaceId> waiting{0};
    met[0] = 1;
    std::size_t count = 0;
    while (!waiting.empty()) {
        const FaceId face = waiting.back();
        waiting.pop_back();
        ++count;
        for (std::uint32_t edge = 3 * face; edge < 3 * face + 3; ++edge) {
            const FaceId next = partition.opposite[edge] / 3;
            if (met[next] == 0)
                waiting.push_back(next);
            met[next] = 1;
        }
    }
    return count;
}

/// A surface that is convex at each edge may still wind around a vertex twice.
bool some_planes_agree(const TriangleMesh& mesh, const Partition& partition, double error)
{
    const std::size_t step = std::max<std::size_t>(1, mesh.face_count() / kPlanes);
    for (std::size_t face = 0; face < mesh.face_count(); face += step) {
        const FacePlane plane(mesh, partition, static_cast<FaceId>(face));
        Heights heights;
        for (const glm::vec3& position : mesh.positions)
            heights.add(plane.height(position));
        if (!heights.are_on_one_side(error))
            return false;
    }
    return true;
}

} // namespace

bool is_convex_solid(const TriangleMesh& mesh, const Partition& partition)
{
    if (mesh.face_count() == 0 || !mesh.copies.empty())
        return false;
    const double error = kErrors * double{partition.position_error};
    Heights heights;
    for (FaceId face = 0; face < mesh.face_count(); ++face)
        if (!partition.is_closed(face) || !(face_area(mesh, face) > 0) ||
            !add_neighbours(mesh, partition, face, heights) || !heights.are_on_one_side(error))
            return false;
    return count_connected(partition) == mesh.face_count() &&
           some_planes_agree(mesh, partition, error);
}

bool sees_from_outside(const Camera& camera, const TriangleMesh& mesh)
{
    double nearest = std::numeric_limits<double>::infinity();
    for (const glm::vec3& position : mesh.positions)
        nearest = std::min(nearest, glm::dot(glm::dvec3(camera.forward),
                                             glm::dvec3(position) - glm::dvec3(camera.position)));
    return nearest > 0 && nearest >= double{camera.near_clip};
}

} // namespace hipmap
