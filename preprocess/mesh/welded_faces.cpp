#include "preprocess/mesh/welded_faces.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <numeric>

namespace hipmap {
namespace {

bool is_degenerate(const TriangleMesh& mesh, FaceId face, const glm::uvec3& welded)
{
    return welded.x == welded.y || welded.y == welded.z || welded.z == welded.x ||
           scaled_normal(mesh, face) == glm::dvec3(0.0);
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

EdgeGroups group_edges(const WeldedFaces& faces)
{
    const auto low = [&](std::uint32_t edge) {
        return std::min(faces.start(edge), faces.end(edge));
    };
    const auto edge_count = static_cast<std::uint32_t>(faces.vertex_of_corner.size());

    // A counting sort by the lower vertex, then a sort of the few edges of each by the higher one.
    std::vector<std::uint32_t> bucket(faces.vertex_count + std::size_t{1}, 0);
    for (std::uint32_t edge = 0; edge < edge_count; ++edge)
        if (!faces.degenerate[edge / 3])
            ++bucket[low(edge) + std::size_t{1}];
    std::partial_sum(bucket.begin(), bucket.end(), bucket.begin());
    std::vector<std::uint64_t> by_high(bucket.back()); // higher vertex, then edge
    std::vector<std::uint32_t> next(bucket.begin(), bucket.end() - 1);
    for (std::uint32_t edge = 0; edge < edge_count; ++edge)
        if (!faces.degenerate[edge / 3])
            by_high[next[low(edge)]++] =
                std::uint64_t{std::max(faces.start(edge), faces.end(edge))} << 32 | edge;
    tbb::parallel_for(std::size_t{0}, std::size_t{faces.vertex_count}, [&](std::size_t v) {
        std::sort(by_high.begin() + bucket[v], by_high.begin() + bucket[v + 1]);
    });

    EdgeGroups groups;
    groups.edges.reserve(by_high.size());
    for (std::size_t v = 0; v < faces.vertex_count; ++v)
        for (std::uint32_t i = bucket[v]; i < bucket[v + 1]; ++i) {
            if (i == bucket[v] || by_high[i] >> 32 != by_high[i - 1] >> 32)
                groups.first.push_back(i);
            groups.edges.push_back(static_cast<std::uint32_t>(by_high[i]));
        }
    groups.first.push_back(static_cast<std::uint32_t>(groups.edges.size()));
    return groups;
}

EdgeGroups without_pairs(const EdgeGroups& groups)
{
    EdgeGroups out;
    for (std::size_t g = 0; g < groups.count(); ++g) {
        if (groups.first[g + 1] - groups.first[g] == 2)
            continue;
        out.first.push_back(static_cast<std::uint32_t>(out.edges.size()));
        out.edges.insert(out.edges.end(), groups.edges.begin() + groups.first[g],
                         groups.edges.begin() + groups.first[g + 1]);
    }
    out.first.push_back(static_cast<std::uint32_t>(out.edges.size()));
    return out;
}

} // namespace hipmap
