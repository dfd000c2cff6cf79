#include "preprocess/mesh/welded_faces.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <utility>

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
    faces.corners.resize(mesh.face_count());
    faces.degenerate.resize(mesh.face_count());
    tbb::parallel_for(std::size_t{0}, mesh.face_count(), [&](std::size_t face) {
        const glm::uvec3 c = mesh.corners[face];
        const glm::uvec3 welded(weld.id_of_vertex[c.x], weld.id_of_vertex[c.y],
                                weld.id_of_vertex[c.z]);
        faces.corners[face] = welded;
        faces.degenerate[face] = is_degenerate(mesh, static_cast<FaceId>(face), welded);
    });
    return faces;
}

EdgeGroups group_edges(const WeldedFaces& faces)
{
    const auto ends = [&](std::uint32_t edge) {
        return std::minmax({faces.start(edge), faces.end(edge)});
    };
    const auto high = [&](std::uint32_t edge) {
        return std::max(faces.start(edge), faces.end(edge));
    };
    const auto edge_count = static_cast<std::uint32_t>(3 * faces.corners.size());

    // A counting sort by the lower vertex, then a sort of the few edges of each by the higher one.
    std::vector<std::uint32_t> bucket(faces.vertex_count + std::size_t{1}, 0);
    for (std::uint32_t edge = 0; edge < edge_count; ++edge)
        if (!faces.degenerate[edge / 3])
            ++bucket[ends(edge).first + 1];
    for (std::size_t v = 0; v < faces.vertex_count; ++v)
        bucket[v + 1] += bucket[v];
    EdgeGroups groups;
    groups.edges.resize(bucket.back());
    std::vector<std::uint32_t> next(bucket.begin(), bucket.end() - 1);
    for (std::uint32_t edge = 0; edge < edge_count; ++edge)
        if (!faces.degenerate[edge / 3])
            groups.edges[next[ends(edge).first]++] = edge;
    tbb::parallel_for(std::size_t{0}, std::size_t{faces.vertex_count}, [&](std::size_t v) {
        std::sort(groups.edges.begin() + bucket[v], groups.edges.begin() + bucket[v + 1],
                  [&](std::uint32_t a, std::uint32_t b) {
                      return std::pair(high(a), a) < std::pair(high(b), b);
                  });
    });

    for (std::uint32_t i = 0; i < groups.edges.size(); ++i)
        if (i == 0 || ends(groups.edges[i]) != ends(groups.edges[i - 1]))
            groups.first.push_back(i);
    groups.first.push_back(static_cast<std::uint32_t>(groups.edges.size()));
    return groups;
}

} // namespace hipmap
