#pragma once

#include "preprocess/partition/map_trees.h"

namespace hipmap {

struct SelfDistances {
    std::vector<std::uint8_t> kept_edges; ///< [F] as in Partition
    std::vector<float> self_distance;     ///< [F] as in Partition
};

/// Bound of the distance between a point that is computed from a face's corners in float and the
/// face, and of how far corners may be apart that were meant to be at one place.  Scene units.
float position_error_of(const TriangleMesh& mesh);

/// Finds for every face of a map how near the map comes to it again, docs/partition_file.md (4),
/// and sets `out`, which has room for all faces of the mesh, at these faces alone.  Of the sets of
/// edges that contain all connected ones, each face keeps the one with the largest limiting radius
/// at any of its points; of equal ones the smallest, then the lowest bits. A face near more of its
/// map than is worth looking through (4096 faces) gets self-distance 0. position_error: at least
/// position_error_of(mesh). Near linear, parallel; the same at any thread count, whatever other
/// maps there are.
void find_self_distances(const MapTree& map, std::span<const EdgeClass> edge_class,
                         double position_error, SelfDistances& out);

} // namespace hipmap
