#include "preprocess/mesh/closed_surfaces.h"

#include "preprocess/mesh/disjoint_sets.h"

#include <cmath>

namespace hipmap {
namespace {

/// Volume over area^(3/2), below which a volume is only rounding.  A sphere has 0.094, a pane of
/// 1 m2 and 1 um thickness 4e-7; the sums below are good to about 1e-15 per face.
constexpr double kLeastVolume = 1e-9;

struct Surface {
    FaceId first_face = 0;
    std::size_t faces = 0;
    double area = 0.0;
    double volume = 0.0;
    bool open = false;

    bool closed() const
    {
        return !open && faces >= 4 && std::abs(volume) > kLeastVolume * std::pow(area, 1.5);
    }
};

/// Adds a face; volumes are those of tetrahedra on a vertex of the surface itself.
void add_face(Surface& surface, const TriangleMesh& mesh, const HalfEdges& edges, FaceId face)
{
    const auto vertex = [&](FaceId f) { return glm::dvec3(mesh.positions[mesh.corners[f].x]); };
    const glm::dvec3 normal = scaled_normal(mesh, face);
    const double volume = glm::dot(vertex(face) - vertex(surface.first_face), normal) / 6;
    ++surface.faces;
    surface.area += 0.5 * glm::length(normal);
    surface.volume += edges.flipped[face] ? -volume : volume;
    for (std::uint32_t c = 0; c < 3; ++c)
        surface.open |= edges.opposite[3 * face + c] == kNone;
}

} // namespace

std::vector<std::uint8_t> find_closed_surfaces(const TriangleMesh& mesh, const HalfEdges& edges)
{
    DisjointSets sets(mesh.face_count());
    for (std::uint32_t edge = 0; edge < edges.opposite.size(); ++edge)
        if (edges.opposite[edge] != kNone)
            sets.unite(edge / 3, edges.opposite[edge] / 3);

    std::vector<std::uint32_t> surface_of_face(mesh.face_count());
    std::vector<Surface> surfaces;
    for (FaceId face = 0; face < mesh.face_count(); ++face) {
        const FaceId root = sets.root(face);
        if (root == face) {
            surface_of_face[face] = static_cast<std::uint32_t>(surfaces.size());
            surfaces.push_back({.first_face = face});
        }
        surface_of_face[face] = surface_of_face[root];
        add_face(surfaces[surface_of_face[face]], mesh, edges, face);
    }
    std::vector<std::uint8_t> closed(mesh.face_count());
    for (FaceId face = 0; face < mesh.face_count(); ++face)
        closed[face] = surfaces[surface_of_face[face]].closed();
    return closed;
}

} // namespace hipmap
