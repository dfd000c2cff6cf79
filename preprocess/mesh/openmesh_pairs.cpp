#include "preprocess/mesh/openmesh_pairs.h"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/System/omstream.hh>

#include <array>
#include <cassert>

namespace hipmap {
namespace {

using Mesh = OpenMesh::TriMesh_ArrayKernelT<>;
using Corners = std::array<OpenMesh::VertexHandle, 3>;

/// Enters a face; its corners are replaced by new vertices if it is refused.  Returns success at
/// the first attempt.
bool enter(Mesh& mesh, Corners& corners, bool flipped)
{
    const auto add = [&] {
        const Corners order{corners[0], corners[flipped ? 2 : 1], corners[flipped ? 1 : 2]};
        return mesh.add_face(order.data(), order.size()).is_valid();
    };
    if (add())
        return true;
    for (OpenMesh::VertexHandle& corner : corners)
        corner = mesh.new_vertex();
    [[maybe_unused]] const bool added = add();
    assert(added && "a face of three new vertices has no neighbour to clash with");
    return false;
}

/// Number of the edge that a half-edge of the face is, whichever way it runs.
std::uint32_t edge_number(const Mesh& mesh, OpenMesh::HalfedgeHandle half_edge, FaceId face,
                          const Corners& corners)
{
    const auto from = mesh.from_vertex_handle(half_edge);
    const auto to = mesh.to_vertex_handle(half_edge);
    std::uint32_t c = 0;
    while (c < 2 && !((corners[c] == from && corners[c + 1] == to) ||
                      (corners[c] == to && corners[c + 1] == from)))
        ++c;
    return 3 * face + c;
}

} // namespace

HalfEdgePairs pair_half_edges(const std::vector<WoundFace>& faces, std::uint32_t vertex_count,
                              std::size_t face_count)
{
    // It reports every refusal on standard error.
    omerr().disable();
    Mesh mesh;
    mesh.reserve(vertex_count, faces.size() + faces.size() / 2, faces.size());
    for (std::uint32_t v = 0; v < vertex_count; ++v)
        mesh.new_vertex();

    HalfEdgePairs pairs;
    std::vector<Corners> corners(faces.size());
    for (std::size_t i = 0; i < faces.size(); ++i) {
        for (int c = 0; c < 3; ++c)
            corners[i][c] = OpenMesh::VertexHandle(static_cast<int>(faces[i].vertices[c]));
        pairs.refused_faces += !enter(mesh, corners[i], faces[i].flipped);
    }

    std::vector<std::uint32_t> edge_of_half_edge(mesh.n_halfedges(), kNone);
    for (std::size_t i = 0; i < faces.size(); ++i)
        for (const auto half_edge : mesh.fh_range(OpenMesh::FaceHandle(static_cast<int>(i))))
            edge_of_half_edge[half_edge.idx()] =
                edge_number(mesh, half_edge, faces[i].id, corners[i]);
    pairs.opposite.assign(3 * face_count, kNone);
    for (std::size_t h = 0; h < edge_of_half_edge.size(); ++h)
        if (edge_of_half_edge[h] != kNone)
            pairs.opposite[edge_of_half_edge[h]] = edge_of_half_edge[h ^ 1];
    return pairs;
}

} // namespace hipmap
