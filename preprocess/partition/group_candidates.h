#pragma once

#include "preprocess/partition/map_trees.h"

namespace hipmap {

struct GroupCandidates {
    std::vector<std::uint32_t> group_of_face; ///< [F] some face of the same group, or kNone
    std::vector<float> group_radius;          ///< [F] as in Partition
};

/// Finds patches of faces, each about 1/64 of a shared map, on which the search of a group map can
/// end within its limiting radius: at some point this exceeds the filter radius of a map with the
/// fewest photons allowed, docs/partition_file.md (3) and (5). out: of all faces of the mesh, kNone
/// and 0 at the faces of the map; the function sets what it finds. Near linear, parallel over
/// patches; the same at any thread count, whatever other maps there are.
void find_group_candidates(const MapTree& map, double position_error, GroupCandidates& out);

} // namespace hipmap
