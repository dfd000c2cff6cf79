#pragma once

#include "preprocess/partition/share_maps.h"

#include <array>

namespace hipmap {

/// The thesis keeps a local map from M = 10 k photons on (its experiments all use this ratio).
inline constexpr double kPhotonsPerNeighbour = 10;

struct LocalCandidates {
    std::vector<float> reach;            ///< [F] as in Partition
    std::vector<std::uint8_t> candidate; ///< [F] 1: worth a local map
};

/// Returns the largest distance of any point of a triangle from the nearest of its chosen edges
/// (segments). corners: any unit; area not zero.  connected: for the edges from corner 0, 1 and 2.
/// Infinity if none is chosen; three: the inradius; one: the distance of the opposite corner; two:
/// see docs/partition_file.md (2).
double reach_of(const std::array<glm::dvec3, 3>& corners, const std::array<bool, 3>& connected);

/// Returns the filter radius of the smallest map that is kept, with 10 k photons spread evenly over
/// `area`, docs/partition_file.md (3).  area: square scene units.
double widest_filter_radius(double area);

/// Finds faces on which the search of a local map can end within its limiting radius: faces that
/// are not alone in their shared map, and whose reach exceeds the filter radius of a local map with
/// the fewest photons allowed, 10 k, docs/partition_file.md (3).  Linear, parallel.
LocalCandidates find_local_candidates(const TriangleMesh& mesh,
                                      std::span<const EdgeClass> edge_class,
                                      const SharedMaps& maps);

} // namespace hipmap
