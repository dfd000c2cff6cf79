#pragma once

#include "preprocess/mesh/half_edges.h"

#include <cstddef>

namespace hipmap {

/// Width of the band, in radians, around the threshold angle.  An edge within it counts as above
/// the threshold, so that the rounding of positions (a rotated cube) cannot change a partition.
inline constexpr double kAngleBand = 1e-4;

/// What separates two neighbouring faces: the angle between them, vertex normals that the scene's
/// author split, or either.
enum class SplitBy { angle, normals, both };

/// Vertex normals of two faces at one vertex that differ by more than this, in radians, count as
/// split on purpose; quantisation to 8 bits makes a smaller difference.
inline constexpr double kSplitNormals = 0.02;

struct EdgeClasses {
    std::vector<EdgeClass> edge_class; ///< [3F]
    std::size_t edges_in_band = 0;     ///< edges within kAngleBand of the threshold
};

/// Makes edges of two faces connected where their fronts (after turning flipped faces) differ by
/// less than the threshold:
///     dot(n1, n2) > cos(threshold - band) |n1| |n2|          with unnormalised normals in double
/// By normals, edges are connected unless the vertex normals of the two faces differ by more than
/// kSplitNormals at an end; an edge with an end that has no normals is judged by its angle.
/// angle_threshold: radians, 0 to pi; 0 connects nothing.  Other classes stay as they are.
/// Linear, parallel.
EdgeClasses classify_edges(const TriangleMesh& mesh, const HalfEdges& edges, double angle_threshold,
                           SplitBy by = SplitBy::angle);

} // namespace hipmap
