#include "preprocess/mesh/openmesh_pairs.h"

#include <OpenMesh/Core/Mesh/TriConnectivity.hh>
#include <OpenMesh/Core/System/omstream.hh>

#include <algorithm>
#include <array>
#include <cassert>

namespace hipmap {
namespace {

/// Without points.
using Mesh = OpenMesh::TriConnectivity;

/// Enters a face; its vertices are replaced by new ones if it is refused.  Returns success at the
/// first attempt.
bool enter(Mesh& mesh, WoundFace& face)
{
    const auto add = [&] {
        const auto vertex = [](std::uint32_t v) { return OpenMesh::VertexHandle(int(v)); };
        const glm::uvec3& v = face.vertices;
        return mesh
            .add_face(vertex(v.x), vertex(face.flipped ? v.z : v.y),
                      vertex(face.flipped ? v.y : v.z))
            .is_valid();
    };
    if (add())
        return true;
    for (int c = 0; c < 3; ++c)
        face.vertices[c] = static_cast<std::uint32_t>(mesh.new_vertex().idx());
    [[maybe_unused]] const bool added = add();
    assert(added && "a face of three new vertices has no neighbour to clash with");
    return false;
}

/// Number of the edge that a half-edge of the face is.
std::uint32_t edge_number(const Mesh& mesh, OpenMesh::HalfedgeHandle half_edge,
                          const WoundFace& face)
{
    // The edge begins where the half-edge does, or ends if the face is flipped.
    const OpenMesh::VertexHandle start =
        face.flipped ? mesh.to_vertex_handle(half_edge) : mesh.from_vertex_handle(half_edge);
    const auto vertex = static_cast<std::uint32_t>(start.idx());
    return 3 * face.id + (vertex == face.vertices.y ? 1 : vertex == face.vertices.z ? 2 : 0);
}

} // namespace

HalfEdgePairs pair_half_edges(std::vector<WoundFace> faces, std::uint32_t vertex_count,
                              std::size_t face_count)
{
    // It reports every refusal on standard error.
    omerr().disable();
    Mesh mesh;
    const std::size_t most_edges = std::min(vertex_count + faces.size(), 3 * faces.size()); // Euler
    mesh.reserve(vertex_count, most_edges, faces.size());
    for (std::uint32_t v = 0; v < vertex_count; ++v)
        mesh.new_vertex();

    HalfEdgePairs pairs;
    for (WoundFace& face : faces)
        pairs.refused_faces += !enter(mesh, face);

    pairs.opposite.assign(3 * face_count, kNone);
    for (std::size_t e = 0; e < mesh.n_edges(); ++e) {
        const OpenMesh::EdgeHandle edge(static_cast<int>(e));
        std::array<std::uint32_t, 2> number;
        for (unsigned side = 0; side < 2; ++side) {
            const auto half_edge = mesh.halfedge_handle(edge, side);
            const auto face = mesh.face_handle(half_edge);
            number[side] =
                face.is_valid()
                    ? edge_number(mesh, half_edge, faces[static_cast<std::size_t>(face.idx())])
                    : kNone;
        }
        for (const unsigned side : {0u, 1u})
            if (number[side] != kNone)
                pairs.opposite[number[side]] = number[1 - side];
    }
    return pairs;
}

} // namespace hipmap
