#include "preprocess/mesh/half_edges.h"

#include "preprocess/mesh/closed_surfaces.h"
#include "preprocess/mesh/disjoint_sets.h"
#include "preprocess/mesh/openmesh_pairs.h"
#include "preprocess/mesh/orient_faces.h"
#include "preprocess/mesh/parts.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <span>
#include <utility>

namespace hipmap {
namespace {

/// A vertex for every corner: corners share one only if a walk around the welded vertex leads from
/// one to the other across paired edges.
struct Fans {
    std::vector<std::uint32_t> vertex_of_corner; ///< [3F]
    std::uint32_t count = 0;
};

Fans split_into_fans(const WeldedFaces& faces, const std::vector<std::uint32_t>& partner)
{
    DisjointSets sets(partner.size());
    for (std::uint32_t edge = 0; edge < partner.size(); ++edge) {
        const std::uint32_t twin = partner[edge];
        if (twin == kNone || twin < edge)
            continue;
        const bool same_direction = faces.start(edge) == faces.start(twin);
        const std::uint32_t after_twin = twin - twin % 3 + (twin % 3 + 1) % 3;
        const std::uint32_t after_edge = edge - edge % 3 + (edge % 3 + 1) % 3;
        sets.unite(edge, same_direction ? twin : after_twin);
        sets.unite(after_edge, same_direction ? after_twin : twin);
    }
    Fans fans;
    fans.vertex_of_corner.resize(partner.size());
    for (std::uint32_t corner = 0; corner < partner.size(); ++corner) {
        const std::uint32_t root = sets.root(corner);
        fans.vertex_of_corner[corner] = root == corner ? fans.count++ : fans.vertex_of_corner[root];
    }
    return fans;
}

/// The edges of two faces that were cut.
std::vector<std::uint32_t> cut_edges(const WeldedFaces& faces, const EdgeGroups& others,
                                     const std::vector<std::uint32_t>& partner)
{
    std::vector<std::uint8_t> grouped(partner.size(), 0);
    for (const std::uint32_t edge : others.edges)
        grouped[edge] = 1;
    std::vector<std::uint32_t> cut;
    for (std::uint32_t edge = 0; edge < partner.size(); ++edge)
        if (partner[edge] == kNone && grouped[edge] == 0 && !faces.degenerate[edge / 3])
            cut.push_back(edge);
    return cut;
}

/// The faces, ascending, of connected surfaces that have an edge of three or more faces, or one
/// that was cut.  On no other surface do two edges have the same two fans at their ends, so that
/// OpenMesh would say of them what the welded edges say.
std::vector<FaceId> faces_to_check(const WeldedFaces& faces, const EdgeGroups& others,
                                   const Orientation& orientation)
{
    std::vector<std::uint32_t> opened;
    if (orientation.cut_edges > 0)
        opened = cut_edges(faces, others, orientation.partner);
    for (std::size_t g = 0; g < others.count(); ++g)
        if (others.first[g + 1] - others.first[g] > 2)
            opened.insert(opened.end(), others.edges.begin() + others.first[g],
                          others.edges.begin() + others.first[g + 1]);
    if (opened.empty())
        return {};
    DisjointSets surfaces(faces.degenerate.size());
    for (std::uint32_t edge = 0; edge < orientation.partner.size(); ++edge)
        if (const std::uint32_t twin = orientation.partner[edge]; twin != kNone && edge < twin)
            surfaces.unite(edge / 3, twin / 3);
    std::vector<std::uint8_t> wanted(faces.degenerate.size(), 0);
    for (const std::uint32_t edge : opened)
        wanted[surfaces.root(edge / 3)] = 1;
    std::vector<FaceId> out;
    for (FaceId face = 0; face < wanted.size(); ++face)
        if (wanted[surfaces.root(face)] != 0 && !faces.degenerate[face])
            out.push_back(face);
    return out;
}

/// Finds the opposites of the edges of all faces, by OpenMesh those of `some`; elsewhere they are
/// the partners.  Opposites are the pairs on which OpenMesh and the welded edges agree.  An edge
/// of several faces is opened, so its faces must stay apart; OpenMesh pairs them nevertheless if
/// the same two fans meet at its ends.
HalfEdgePairs find_opposites(const WeldedFaces& faces, Orientation& orientation,
                             std::span<const FaceId> some)
{
    if (some.empty())
        return {std::move(orientation.partner), 0};
    Fans fans = split_into_fans(faces, orientation.partner);
    std::vector<WoundFace> wound;
    wound.reserve(some.size());
    for (const FaceId face : some) {
        const std::uint32_t* v = &fans.vertex_of_corner[std::size_t{3} * face];
        wound.push_back({face, {v[0], v[1], v[2]}, orientation.flipped[face] != 0});
    }
    fans.vertex_of_corner = {};
    const HalfEdgePairs pairs =
        pair_half_edges(std::move(wound), fans.count, faces.degenerate.size());
    std::vector<std::uint32_t> opposite = std::move(orientation.partner);
    for (const FaceId face : some)
        for (std::uint32_t edge = 3 * face; edge < 3 * face + 3; ++edge)
            if (opposite[edge] != pairs.opposite[edge])
                opposite[edge] = kNone;
    return {std::move(opposite), pairs.refused_faces};
}

void set_classes(HalfEdges& out, const WeldedFaces& faces, const EdgeGroups& others)
{
    out.edge_class.resize(out.opposite.size());
    tbb::parallel_for(std::size_t{0}, faces.degenerate.size(), [&](std::size_t face) {
        for (std::size_t edge = 3 * face; edge < 3 * face + 3; ++edge)
            out.edge_class[edge] = faces.degenerate[face] != 0   ? EdgeClass::degenerate
                                   : out.opposite[edge] == kNone ? EdgeClass::non_manifold
                                                                 : EdgeClass::unconnected;
    });
    for (std::size_t g = 0; g < others.count(); ++g) {
        const bool is_border = others.first[g + 1] - others.first[g] == 1;
        ++(is_border ? out.defects.border_edges : out.defects.non_manifold_edges);
        if (is_border)
            out.edge_class[others.edges[others.first[g]]] = EdgeClass::border;
    }
}

} // namespace

HalfEdges find_half_edges(const TriangleMesh& mesh, const VertexWeld& weld)
{
    const WeldedFaces faces = weld_faces(mesh, weld);
    EdgePairs pairs = pair_edges(faces, parts_for(mesh.face_count()));
    const EdgeGroups others = std::move(pairs.others);
    Orientation orientation = orient_faces(mesh, faces, std::move(pairs));
    HalfEdgePairs opposites =
        find_opposites(faces, orientation, faces_to_check(faces, others, orientation));

    HalfEdges out;
    out.defects.degenerate_faces =
        static_cast<std::size_t>(std::ranges::count(faces.degenerate, 1));
    out.defects.flipped_faces =
        static_cast<std::size_t>(std::ranges::count(orientation.flipped, 1));
    out.defects.cut_edges = orientation.cut_edges;
    out.defects.refused_faces = opposites.refused_faces;
    out.flipped = std::move(orientation.flipped);
    out.opposite = std::move(opposites.opposite);
    set_classes(out, faces, others);
    out.closed = find_closed_surfaces(mesh, faces, others, out);
    return out;
}

} // namespace hipmap
