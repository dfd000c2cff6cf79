#include "preprocess/mesh/half_edges.h"

#include "preprocess/mesh/closed_surfaces.h"
#include "preprocess/mesh/disjoint_sets.h"
#include "preprocess/mesh/openmesh_pairs.h"
#include "preprocess/mesh/orient_faces.h"

#include <algorithm>

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

HalfEdgePairs pair_by_openmesh(const WeldedFaces& faces, const Orientation& orientation)
{
    Fans fans = split_into_fans(faces, orientation.partner);
    std::vector<WoundFace> wound;
    wound.reserve(faces.degenerate.size());
    for (FaceId face = 0; face < faces.degenerate.size(); ++face) {
        if (faces.degenerate[face])
            continue;
        const std::uint32_t* v = &fans.vertex_of_corner[std::size_t{3} * face];
        wound.push_back({face, {v[0], v[1], v[2]}, orientation.flipped[face] != 0});
    }
    fans.vertex_of_corner = {};
    return pair_half_edges(std::move(wound), fans.count, faces.degenerate.size());
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
    HalfEdgePairs pairs = pair_by_openmesh(faces, orientation);

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
