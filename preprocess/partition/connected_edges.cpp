#include "preprocess/partition/connected_edges.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace hipmap {
namespace {

/// Cosines between which an edge counts as at the threshold.
struct AngleTest {
    double above; ///< a greater cosine is connected
    double below; ///< a smaller one is surely not

    explicit AngleTest(double threshold)
        : above(threshold > kAngleBand ? std::cos(threshold - kAngleBand)
                                       : std::numeric_limits<double>::infinity()),
          below(std::cos(std::min(threshold + kAngleBand, std::numbers::pi)))
    {
    }
};

glm::dvec3 outward_normal(const TriangleMesh& mesh, const HalfEdges& edges, FaceId face)
{
    const glm::dvec3 normal = scaled_normal(mesh, face);
    return edges.flipped[face] ? -normal : normal;
}

/// Whether the author split the vertex normals along an edge; nothing if there are none.
std::optional<bool> is_split(const TriangleMesh& mesh, std::uint32_t edge, std::uint32_t twin)
{
    const auto corner = [&](std::uint32_t of, std::uint32_t offset) {
        return mesh.corners[of / 3][static_cast<int>((of % 3 + offset) % 3)];
    };
    const auto apart = [&](std::uint32_t end, std::uint32_t twin_end) {
        return glm::distance(glm::dvec3(mesh.positions[corner(edge, end)]),
                             glm::dvec3(mesh.positions[corner(twin, twin_end)]));
    };
    // Near positions may have been welded, so that ends need not be equal.
    const bool opposite_ways = apart(0, 1) + apart(1, 0) < apart(0, 0) + apart(1, 1);
    bool split = false;
    for (const std::uint32_t end : {0u, 1u}) {
        const glm::dvec3 n1(mesh.normals[corner(edge, end)]);
        const glm::dvec3 n2(mesh.normals[corner(twin, opposite_ways ? 1 - end : end)]);
        const double lengths = glm::length(n1) * glm::length(n2);
        if (!(lengths > 0))
            return {};
        split |= glm::dot(n1, n2) < std::cos(kSplitNormals) * lengths;
    }
    return split;
}

} // namespace

EdgeClasses classify_edges(const TriangleMesh& mesh, const HalfEdges& edges, double angle_threshold,
                           SplitBy by)
{
    const AngleTest test(angle_threshold);
    EdgeClasses out;
    out.edge_class = edges.edge_class;
    std::vector<std::uint8_t> in_band(edges.opposite.size());
    tbb::parallel_for(std::size_t{0}, edges.opposite.size(), [&](std::size_t edge) {
        const std::uint32_t twin = edges.opposite[edge];
        if (twin == kNone || twin < edge) // both halves of an edge are alike
            return;
        if (by != SplitBy::angle) {
            const std::optional<bool> split =
                is_split(mesh, static_cast<std::uint32_t>(edge), twin);
            if (split && *split)
                return;
            if (split && by == SplitBy::normals) {
                out.edge_class[edge] = out.edge_class[twin] = EdgeClass::connected;
                return;
            }
        }
        const glm::dvec3 n1 = outward_normal(mesh, edges, static_cast<FaceId>(edge / 3));
        const glm::dvec3 n2 = outward_normal(mesh, edges, twin / 3);
        const double dot = glm::dot(n1, n2);
        const double lengths = glm::length(n1) * glm::length(n2);
        if (dot > test.above * lengths)
            out.edge_class[edge] = out.edge_class[twin] = EdgeClass::connected;
        else
            in_band[edge] = dot >= test.below * lengths;
    });
    out.edges_in_band = static_cast<std::size_t>(std::ranges::count(in_band, 1));
    return out;
}

} // namespace hipmap
