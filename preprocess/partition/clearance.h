#pragma once

#include "preprocess/partition/face_tree.h"
#include "preprocess/partition/share_maps.h"

namespace hipmap {

struct Clearances {
    std::vector<std::uint8_t> kept_edges; ///< [F] as in Partition
    std::vector<float> clearance;         ///< [F] as in Partition
};

/// Bound of the distance between a point that is computed from a face's corners in float and the
/// face, and of how far corners may be apart that were meant to be at one place.  Scene units.
float position_error_of(const TriangleMesh& mesh);

/// Finds for every face how near its shared map comes to it again, docs/partition_file.md (4).  Of
/// the sets of edges that contain all connected ones, each face keeps the one with the largest
/// limiting radius at any of its points; of equal ones the smallest, then the lowest bits.
/// A face near more of its map than is worth looking through (4096 faces) gets clearance 0.
/// tree: all faces that have a map.  position_error: at least position_error_of(mesh).
/// Near linear, parallel; the same at any thread count.
Clearances find_clearances(const TriangleMesh& mesh, std::span<const EdgeClass> edge_class,
                           const SharedMaps& maps, const FaceTree& tree, double position_error);

} // namespace hipmap
