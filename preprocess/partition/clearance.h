#pragma once

#include "preprocess/partition/share_maps.h"

namespace hipmap {

struct Clearances {
    std::vector<std::uint8_t> kept_edges; ///< [F] as in Partition
    std::vector<float> clearance;         ///< [F] as in Partition
    float position_error = 0.0f;          ///< as in Partition
};

/// Finds for every face how near its shared map comes to it again, docs/partition_file.md (4).  Of
/// the sets of edges that contain all connected ones, each face keeps the one with the largest
/// limiting radius at any of its points; of equal ones the smallest, then the lowest bits.
/// A face near more of its map than is worth looking through (4096 faces) gets clearance 0.
/// Near linear, parallel; the same at any thread count.
Clearances find_clearances(const TriangleMesh& mesh, std::span<const EdgeClass> edge_class,
                           const SharedMaps& maps);

} // namespace hipmap
