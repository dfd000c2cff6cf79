#include "bench/edge_count.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace hipmap {
namespace {

/// [V] the same number for the same position.
std::vector<std::uint32_t> number_positions(const std::vector<glm::vec3>& positions)
{
    const auto key = [&](std::uint32_t vertex) {
        const glm::vec3& p = positions[vertex];
        return std::tie(p.x, p.y, p.z);
    };
    std::vector<std::uint32_t> order(positions.size());
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::sort(order, {}, key);
    std::vector<std::uint32_t> number(positions.size());
    for (std::size_t i = 1; i < order.size(); ++i)
        number[order[i]] = number[order[i - 1]] + (key(order[i]) != key(order[i - 1]));
    return number;
}

struct Edge {
    ObjectId object = 0;
    std::uint32_t low = 0, high = 0; ///< ends

    auto operator<=>(const Edge&) const = default;
};

std::vector<Edge> sorted_edges(const TriangleMesh& mesh, bool by_object)
{
    const std::vector<std::uint32_t> number = number_positions(mesh.positions);
    std::vector<Edge> edges;
    for (FaceId face = 0; face < mesh.face_count(); ++face) {
        const glm::uvec3& corners = mesh.corners[face];
        const glm::uvec3 v(number[corners.x], number[corners.y], number[corners.z]);
        if (v.x == v.y || v.y == v.z || v.z == v.x)
            continue;
        for (int c = 0; c < 3; ++c) {
            const auto [low, high] = std::minmax(v[c], v[(c + 1) % 3]);
            edges.push_back({by_object ? mesh.object_of_face[face] : 0, low, high});
        }
    }
    std::ranges::sort(edges);
    return edges;
}

} // namespace

std::vector<EdgeCount> count_edges(const TriangleMesh& mesh, bool by_object)
{
    const std::vector<Edge> edges = sorted_edges(mesh, by_object);
    std::vector<EdgeCount> counts(by_object ? mesh.object_names.size() : 1);
    for (auto at = edges.begin(); at != edges.end();) {
        const auto next = std::find_if(at, edges.end(), [&](const Edge& e) { return e != *at; });
        EdgeCount& count = counts[at->object];
        ++(next - at == 1 ? count.border : next - at == 2 ? count.pairs : count.several);
        at = next;
    }
    return counts;
}

} // namespace hipmap
