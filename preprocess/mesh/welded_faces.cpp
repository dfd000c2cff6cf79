#include "preprocess/mesh/welded_faces.h"

#include "preprocess/mesh/parts.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <span>

namespace hipmap {
namespace {

bool is_degenerate(const TriangleMesh& mesh, FaceId face, const glm::uvec3& welded)
{
    return welded.x == welded.y || welded.y == welded.z || welded.z == welded.x ||
           scaled_normal(mesh, face) == glm::dvec3(0.0);
}

/// Calls visit(lower vertex, edge) for every edge of a face that is not degenerate and whose lower
/// vertex is in a part of the vertices.
template <typename Visit>
void for_each_edge_of(const WeldedFaces& faces, const Part& part, const Visit& visit)
{
    const auto size = static_cast<std::uint32_t>(part.end - part.begin);
    const auto begin = static_cast<std::uint32_t>(part.begin);
    for (std::size_t face = 0; face < faces.degenerate.size(); ++face) {
        if (faces.degenerate[face] != 0)
            continue;
        const std::uint32_t* v = &faces.vertex_of_corner[3 * face];
        const auto edge = static_cast<std::uint32_t>(3 * face);
        const std::array<std::uint32_t, 3> low{std::min(v[0], v[1]), std::min(v[1], v[2]),
                                               std::min(v[2], v[0])};
        for (std::uint32_t corner = 0; corner < 3; ++corner)
            if (low[corner] - begin < size) // wraps for those before
                visit(low[corner] - begin, edge + corner);
    }
}

void append_group(EdgeGroups& groups, const std::uint32_t* begin, const std::uint32_t* end)
{
    groups.edges.insert(groups.edges.end(), begin, end);
    groups.first.push_back(static_cast<std::uint32_t>(groups.edges.size()));
}

/// What one part of the vertices says of edges.
struct PartOfPairs {
    EdgeGroups others;
    bool wound_alike = true;
};

/// Takes in the edges between a vertex and one higher.
void take_group(const WeldedFaces& faces, std::span<const std::uint64_t> group,
                std::vector<std::uint32_t>& partner, PartOfPairs& out)
{
    const auto edge = [&](std::size_t i) { return static_cast<std::uint32_t>(group[i]); };
    if (group.size() == 2) {
        partner[edge(0)] = edge(1);
        partner[edge(1)] = edge(0);
        out.wound_alike = out.wound_alike && faces.start(edge(0)) != faces.start(edge(1));
        return;
    }
    for (std::size_t i = 0; i < group.size(); ++i)
        out.others.edges.push_back(edge(i));
    out.others.first.push_back(static_cast<std::uint32_t>(out.others.edges.size()));
}

/// Pairs the edges whose lower vertex is in a part of the vertices.
PartOfPairs pair_part(const WeldedFaces& faces, const Part& part,
                      std::vector<std::uint32_t>& partner)
{
    // A counting sort by the lower vertex, then a sort of the few edges of each by the higher one.
    std::vector<std::uint32_t> end(part.end - part.begin + 1, 0); // of the edges of each vertex
    for_each_edge_of(faces, part, [&](std::uint32_t low, std::uint32_t) { ++end[low + 1]; });
    std::partial_sum(end.begin(), end.end(), end.begin());
    std::vector<std::uint64_t> by_high(end.back()); // higher vertex, then edge
    for_each_edge_of(faces, part, [&](std::uint32_t low, std::uint32_t edge) {
        by_high[end[low]++] =
            std::uint64_t{std::max(faces.start(edge), faces.end(edge))} << 32 | edge;
    });

    PartOfPairs out;
    std::size_t begin = 0;
    for (std::size_t low = 0; low + 1 < end.size(); ++low) {
        const auto edges = std::span(by_high).subspan(begin, end[low] - begin);
        begin = end[low];
        std::ranges::sort(edges);
        for (std::size_t i = 0, j = 0; i < edges.size(); i = j) {
            while (j < edges.size() && edges[j] >> 32 == edges[i] >> 32)
                ++j;
            take_group(faces, edges.subspan(i, j - i), partner, out);
        }
    }
    return out;
}

} // namespace

WeldedFaces weld_faces(const TriangleMesh& mesh, const VertexWeld& weld)
{
    WeldedFaces faces;
    faces.vertex_count = weld.count;
    faces.vertex_of_corner.resize(3 * mesh.face_count());
    faces.degenerate.resize(mesh.face_count());
    tbb::parallel_for(std::size_t{0}, mesh.face_count(), [&](std::size_t face) {
        const glm::uvec3 c = mesh.corners[face];
        const glm::uvec3 welded(weld.id_of_vertex[c.x], weld.id_of_vertex[c.y],
                                weld.id_of_vertex[c.z]);
        for (int corner = 0; corner < 3; ++corner)
            faces.vertex_of_corner[3 * face + static_cast<std::size_t>(corner)] = welded[corner];
        faces.degenerate[face] = is_degenerate(mesh, static_cast<FaceId>(face), welded);
    });
    return faces;
}

EdgePairs pair_edges(const WeldedFaces& faces, std::size_t parts)
{
    EdgePairs out;
    out.partner.resize(faces.vertex_of_corner.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, out.partner.size()),
                      [&](const auto& range) {
                          std::fill(out.partner.begin() + range.begin(),
                                    out.partner.begin() + range.end(), kNone);
                      });
    std::vector<PartOfPairs> found(parts);
    for_each_part(parts, [&](std::size_t i) {
        found[i] = pair_part(faces, part_of(faces.vertex_count, i, parts), out.partner);
    });
    for (const PartOfPairs& part : found) {
        out.wound_alike = out.wound_alike && part.wound_alike;
        for (std::size_t g = 0; g < part.others.count(); ++g)
            append_group(out.others, part.others.edges.data() + part.others.first[g],
                         part.others.edges.data() + part.others.first[g + 1]);
    }
    return out;
}

} // namespace hipmap
