#include "preprocess/mesh/closed_surfaces.h"

#include "preprocess/mesh/disjoint_sets.h"

#include <tbb/parallel_for.h>

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

/// What a face adds to its surface; volumes are those of tetrahedra on a vertex of the surface.
struct FaceTerms {
    FaceId first_face = 0; ///< of its surface
    double area = 0.0;
    double volume = 0.0;
};

FaceTerms terms_of(const TriangleMesh& mesh, FaceId face, FaceId first_face, bool flipped)
{
    const auto vertex = [&](FaceId f) { return glm::dvec3(mesh.positions[mesh.corners[f].x]); };
    const glm::dvec3 normal = scaled_normal(mesh, face);
    const double volume = glm::dot(vertex(face) - vertex(first_face), normal) / 6;
    return {first_face, 0.5 * glm::length(normal), flipped ? -volume : volume};
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

/// Where surfaces go on across edges that have no opposite.
struct Continuations {
    std::vector<std::uint32_t> edges; ///< ascending
    std::vector<std::pair<FaceId, FaceId>> joined;

    bool has(std::uint32_t edge) const { return std::ranges::binary_search(edges, edge); }
};

/// Joins, on an edge of several faces, the two faces of each object that has two, if they are wound
/// alike.
void join_touching(Continuations& out, const TriangleMesh& mesh, const WeldedFaces& faces,
                   const HalfEdges& edges, std::span<const std::uint32_t> group)
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
            runs_forward(edge) != runs_forward(*partner)) {
            out.edges.push_back(edge);
            out.joined.emplace_back(edge / 3, *partner / 3);
        }
    }
}

Continuations find_continuations(const TriangleMesh& mesh, const WeldedFaces& faces,
                                 const EdgeGroups& others, const HalfEdges& edges)
{
    const Cracks cracks = find_cracks(faces);
    Continuations out;
    for (std::size_t g = 0; g < others.count(); ++g) {
        const auto group =
            std::span(others.edges).subspan(others.first[g], others.first[g + 1] - others.first[g]);
        if (group.size() > 2)
            join_touching(out, mesh, faces, edges, group);
        else if (std::ranges::binary_search(cracks, ends_of(faces, group[0])))
            out.edges.push_back(group[0]);
    }
    std::ranges::sort(out.edges);
    return out;
}

/// Returns [F] the lowest face of each face's surface.
std::vector<FaceId> find_first_faces(const HalfEdges& edges, const Continuations& beyond)
{
    const std::size_t face_count = edges.opposite.size() / 3;
    DisjointSets sets(face_count);
    tbb::parallel_for(std::size_t{0}, edges.opposite.size(), [&](std::size_t edge) {
        if (const std::uint32_t twin = edges.opposite[edge]; twin != kNone && twin > edge)
            sets.unite(static_cast<FaceId>(edge / 3), twin / 3);
    });
    for (const auto& [face, other] : beyond.joined)
        sets.unite(face, other);
    std::vector<FaceId> first(face_count);
    tbb::parallel_for(std::size_t{0}, face_count, [&](std::size_t face) {
        first[face] = sets.root(static_cast<FaceId>(face));
    });
    return first;
}

/// Adds up surfaces, numbered by lowest face.  What faces add is found in parallel, a
/// block at a time, and added in their order, so that the sums are the same at any thread count.
/// surface_of_face: [F] the lowest face of each face's surface; becomes its number.
std::vector<Surface> measure_surfaces(const TriangleMesh& mesh, const HalfEdges& edges,
                                      const Continuations& beyond,
                                      std::vector<std::uint32_t>& surface_of_face)
{
    constexpr std::size_t kBlock = 1 << 16;
    std::vector<Surface> surfaces;
    std::vector<FaceTerms> terms(std::min(kBlock, mesh.face_count()));
    for (std::size_t begin = 0; begin < mesh.face_count(); begin += kBlock) {
        const std::size_t end = std::min(begin + kBlock, mesh.face_count());
        tbb::parallel_for(begin, end, [&](std::size_t face) {
            terms[face - begin] = terms_of(mesh, static_cast<FaceId>(face), surface_of_face[face],
                                           edges.flipped[face] != 0);
        });
        for (std::size_t face = begin; face < end; ++face) {
            const FaceTerms& of_face = terms[face - begin];
            if (of_face.first_face == face) {
                surface_of_face[face] = static_cast<std::uint32_t>(surfaces.size());
                surfaces.emplace_back();
            } else {
                surface_of_face[face] = surface_of_face[of_face.first_face];
            }
            Surface& surface = surfaces[surface_of_face[face]];
            ++surface.faces;
            surface.area += of_face.area;
            surface.volume += of_face.volume;
            for (std::size_t edge = 3 * face; edge < 3 * face + 3; ++edge)
                if (const auto e = static_cast<std::uint32_t>(edge);
                    edges.opposite[edge] == kNone && !beyond.has(e))
                    add_end(surface, mesh, edges, e);
        }
    }
    return surfaces;
}

} // namespace

std::vector<std::uint8_t> find_closed_surfaces(const TriangleMesh& mesh, const WeldedFaces& faces,
                                               const EdgeGroups& others, const HalfEdges& edges)
{
    const Continuations beyond = find_continuations(mesh, faces, others, edges);
    std::vector<std::uint32_t> surface_of_face = find_first_faces(edges, beyond);
    const std::vector<Surface> surfaces = measure_surfaces(mesh, edges, beyond, surface_of_face);
    std::vector<std::uint8_t> closed(mesh.face_count());
    tbb::parallel_for(std::size_t{0}, mesh.face_count(), [&](std::size_t face) {
        closed[face] = surfaces[surface_of_face[face]].closed();
    });
    return closed;
}

} // namespace hipmap
