#include "preprocess/mesh/half_edges.h"

#include "preprocess/mesh/closed_surfaces.h"
#include "preprocess/mesh/disjoint_sets.h"
#include "preprocess/mesh/openmesh_pairs.h"
#include "preprocess/mesh/orient_faces.h"

#include <algorithm>
#include <span>

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

/// The edges of two faces that were cut.  groups: all but those of two edges.
std::vector<std::uint32_t> cut_edges(const WeldedFaces& faces, const EdgeGroups& groups,
                                     const std::vector<std::uint32_t>& partner)
{
    std::vector<std::uint8_t> grouped(partner.size(), 0);
    for (const std::uint32_t edge : groups.edges)
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
std::vector<FaceId> faces_to_check(const WeldedFaces& faces, const EdgeGroups& groups,
                                   const Orientation& orientation)
{
    std::vector<std::uint32_t> opened;
    if (orientation.cut_edges > 0)
        opened = cut_edges(faces, groups, orientation.partner);
    for (std::size_t g = 0; g < groups.count(); ++g)
        if (groups.first[g + 1] - groups.first[g] > 2)
            opened.insert(opened.end(), groups.edges.begin() + groups.first[g],
                          groups.edges.begin() + groups.first[g + 1]);
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

/// Pairs the edges of all faces, by OpenMesh those of `some`.
HalfEdgePairs pair_edges(const WeldedFaces& faces, const Orientation& orientation,
                         std::span<const FaceId> some)
{
    if (some.empty())
        return {orientation.partner, 0};
    Fans fans = split_into_fans(faces, orientation.partner);
    std::vector<WoundFace> wound;
    wound.reserve(some.size());
    for (const FaceId face : some) {
        const std::uint32_t* v = &fans.vertex_of_corner[std::size_t{3} * face];
        wound.push_back({face, {v[0], v[1], v[2]}, orientation.flipped[face] != 0});
    }
    fans.vertex_of_corner = {};
    HalfEdgePairs pairs = pair_half_edges(std::move(wound), fans.count, faces.degenerate.size());
    std::vector<std::uint32_t> opposite = orientation.partner;
    for (const FaceId face : some)
        for (std::uint32_t edge = 3 * face; edge < 3 * face + 3; ++edge)
            opposite[edge] = pairs.opposite[edge];
    return {std::move(opposite), pairs.refused_faces};
}

/// Opposites are those on which OpenMesh and the welded edges agree: where an edge of several faces
/// was opened but the same fans meet at both of its ends, OpenMesh pairs what must stay apart.
/// groups: all but those of two edges.
void set_classes(HalfEdges& out, const WeldedFaces& faces, const EdgeGroups& groups,
                 const std::vector<std::uint32_t>& partner)
{
    out.edge_class.assign(partner.size(), EdgeClass::degenerate);
    for (std::uint32_t edge = 0; edge < partner.size(); ++edge) {
        if (out.opposite[edge] != partner[edge])
            out.opposite[edge] = kNone;
        if (!faces.degenerate[edge / 3])
            out.edge_class[edge] =
                out.opposite[edge] == kNone ? EdgeClass::non_manifold : EdgeClass::unconnected;
    }
    for (std::size_t g = 0; g < groups.count(); ++g) {
        const bool is_border = groups.first[g + 1] - groups.first[g] == 1;
        ++(is_border ? out.defects.border_edges : out.defects.non_manifold_edges);
        if (is_border)
            out.edge_class[groups.edges[groups.first[g]]] = EdgeClass::border;
    }
}

} // namespace

HalfEdges find_half_edges(const TriangleMesh& mesh, const VertexWeld& weld)
{
    const WeldedFaces faces = weld_faces(mesh, weld);
    EdgeGroups groups = group_edges(faces);
    Orientation orientation = orient_faces(mesh, faces, groups);
    groups = without_pairs(groups); // most are, and `orientation` has them
    HalfEdgePairs pairs =
        pair_edges(faces, orientation, faces_to_check(faces, groups, orientation));

    HalfEdges out;
    out.defects.degenerate_faces =
        static_cast<std::size_t>(std::ranges::count(faces.degenerate, 1));
    out.defects.flipped_faces =
        static_cast<std::size_t>(std::ranges::count(orientation.flipped, 1));
    out.defects.cut_edges = orientation.cut_edges;
    out.defects.refused_faces = pairs.refused_faces;
    out.flipped = std::move(orientation.flipped);
    out.opposite = std::move(pairs.opposite);
    set_classes(out, faces, groups, orientation.partner);
    out.closed = find_closed_surfaces(mesh, faces, groups, out);
    return out;
}

} // namespace hipmap
