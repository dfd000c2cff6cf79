#include "preprocess/mesh/closed_surfaces.h"

#include "preprocess/mesh/disjoint_sets.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

namespace hipmap {
namespace {

/// Volume over area^(3/2), below which a volume is only rounding.  A sphere has 0.094, a pane of
/// 1 m2 and 1 um thickness 4e-7; the sums below are good to about 1e-15 per face.
constexpr double kLeastVolume = 1e-9;

/// Length of the border over area^(1/2), up to which a surface counts as closed: all holes of a
/// sphere that fills an image of 1000 pixels are then, together, about half a pixel around.
constexpr double kWidestPinhole = 1e-3;

struct Surface {
    FaceId first_face = 0;
    std::size_t faces = 0;
    double area = 0.0;
    double volume = 0.0;
    double border = 0.0; ///< length
    bool open = false;   ///< it ends elsewhere than at a border

    bool closed() const
    {
        return !open && border <= kWidestPinhole * std::sqrt(area) && faces >= 4 &&
               std::abs(volume) > kLeastVolume * std::pow(area, 1.5);
    }
};

/// Adds a face; volumes are those of tetrahedra on a vertex of the surface itself.
void add_face(Surface& surface, const TriangleMesh& mesh, FaceId face, bool flipped)
{
    const auto vertex = [&](FaceId f) { return glm::dvec3(mesh.positions[mesh.corners[f].x]); };
    const glm::dvec3 normal = scaled_normal(mesh, face);
    const double volume = glm::dot(vertex(face) - vertex(surface.first_face), normal) / 6;
    ++surface.faces;
    surface.area += 0.5 * glm::length(normal);
    surface.volume += flipped ? -volume : volume;
}

/// Adds an edge at which the surface ends.
void add_end(Surface& surface, const TriangleMesh& mesh, const HalfEdges& edges, std::uint32_t edge)
{
    const glm::uvec3& corners = mesh.corners[edge / 3];
    const auto corner = static_cast<glm::length_t>(edge % 3);
    const glm::dvec3 from(mesh.positions[corners[corner]]);
    const glm::dvec3 to(mesh.positions[corners[(corner + 1) % 3]]);
    if (edges.edge_class[edge] == EdgeClass::border)
        surface.border += glm::length(to - from);
    else
        surface.open = true;
}

/// The ends of the edges of faces without area but with three vertices, sorted.
using Cracks = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

std::pair<std::uint32_t, std::uint32_t> ends_of(const WeldedFaces& faces, std::uint32_t edge)
{
    return std::minmax({faces.start(edge), faces.end(edge)});
}

Cracks find_cracks(const WeldedFaces& faces)
{
    Cracks cracks;
    for (FaceId face = 0; face < faces.degenerate.size(); ++face) {
        const std::uint32_t* c = &faces.vertex_of_corner[std::size_t{3} * face];
        if (faces.degenerate[face] && c[0] != c[1] && c[1] != c[2] && c[2] != c[0])
            for (std::uint32_t corner = 0; corner < 3; ++corner)
                cracks.push_back(ends_of(faces, 3 * face + corner));
    }
    std::ranges::sort(cracks);
    return cracks;
}

/// Joins, on an edge of several faces, the two faces of each object that has two, if they are wound
/// alike.
void join_touching(std::vector<std::uint32_t>& beyond, const TriangleMesh& mesh,
                   const WeldedFaces& faces, const HalfEdges& edges,
                   std::span<const std::uint32_t> group)
{
    const auto object = [&](std::uint32_t edge) { return mesh.object_of_face[edge / 3]; };
    const auto runs_forward = [&](std::uint32_t edge) {
        return (faces.start(edge) < faces.end(edge)) != (edges.flipped[edge / 3] != 0);
    };
    for (const std::uint32_t edge : group) {
        const auto is_partner = [&](std::uint32_t other) {
            return other != edge && object(other) == object(edge);
        };
        const auto partner = std::ranges::find_if(group, is_partner);
        if (std::ranges::count_if(group, is_partner) == 1 &&
            runs_forward(edge) != runs_forward(*partner))
            beyond[edge] = *partner;
    }
}

/// For every edge the one where its surface goes on: itself at a crack, kNone where the surface
/// ends.
std::vector<std::uint32_t> find_continuations(const TriangleMesh& mesh, const WeldedFaces& faces,
                                              const EdgeGroups& groups, const HalfEdges& edges)
{
    const Cracks cracks = find_cracks(faces);
    std::vector<std::uint32_t> beyond = edges.opposite;
    for (std::size_t g = 0; g < groups.count(); ++g) {
        const auto group =
            std::span(groups.edges).subspan(groups.first[g], groups.first[g + 1] - groups.first[g]);
        if (group.size() > 2)
            join_touching(beyond, mesh, faces, edges, group);
        else if (group.size() == 1 && std::ranges::binary_search(cracks, ends_of(faces, group[0])))
            beyond[group[0]] = group[0];
    }
    return beyond;
}

} // namespace

std::vector<std::uint8_t> find_closed_surfaces(const TriangleMesh& mesh, const WeldedFaces& faces,
                                               const EdgeGroups& groups, const HalfEdges& edges)
{
    const std::vector<std::uint32_t> beyond = find_continuations(mesh, faces, groups, edges);
    DisjointSets sets(mesh.face_count());
    for (std::uint32_t edge = 0; edge < beyond.size(); ++edge)
        if (beyond[edge] != kNone && beyond[edge] > edge) // the other one says the same
            sets.unite(edge / 3, beyond[edge] / 3);

    std::vector<std::uint32_t> surface_of_face(mesh.face_count());
    std::vector<Surface> surfaces;
    for (FaceId face = 0; face < mesh.face_count(); ++face) {
        const FaceId root = sets.root(face);
        if (root == face) {
            surface_of_face[face] = static_cast<std::uint32_t>(surfaces.size());
            surfaces.push_back({.first_face = face});
        }
        surface_of_face[face] = surface_of_face[root];
        Surface& surface = surfaces[surface_of_face[face]];
        add_face(surface, mesh, face, edges.flipped[face] != 0);
        for (std::uint32_t c = 0; c < 3; ++c)
            if (beyond[std::size_t{3} * face + c] == kNone)
                add_end(surface, mesh, edges, 3 * face + c);
    }
    std::vector<std::uint8_t> closed(mesh.face_count());
    for (FaceId face = 0; face < mesh.face_count(); ++face)
        closed[face] = surfaces[surface_of_face[face]].closed();
    return closed;
}

} // namespace hipmap
