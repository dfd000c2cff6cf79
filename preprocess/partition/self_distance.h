#pragma once

#include "preprocess/partition/map_trees.h"

namespace hipmap {

struct SelfDistances {
    std::vector<std::uint8_t> kept_edges; ///< [F] as in Partition
    std::vector<float> self_distance;     ///< [F] as in Partition
};

/// Returns a bound of the distance between a face and a point computed from its corners in float,
/// and of how far apart corners may be that were meant to coincide.  Scene units.
float position_error_of(const TriangleMesh& mesh);

/// Finds for every face of a map its self-distance: how near the map comes to the face again,
/// docs/partition_file.md (4).  Sets `out`, which has room for all faces of the mesh, at these
/// faces alone.  Of the sets of edges that contain all connected ones, each face keeps the one with
/// the largest limiting radius at any of its points; of equal ones the smallest, then the lowest
/// bits. A face with too many faces of its map around it (4096) gets self-distance 0.
/// position_error: at least position_error_of(mesh). Near linear, parallel; the same at any thread
/// count, whatever other maps there are.
void find_self_distances(const MapTree& map, std::span<const EdgeClass> edge_class,
                         double position_error, SelfDistances& out);

} // namespace hipmap
