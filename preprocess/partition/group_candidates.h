#pragma once

#include "preprocess/partition/map_trees.h"

namespace hipmap {

struct GroupCandidates {
    std::vector<std::uint32_t> group_of_face; ///< [F] some face of the same group, or kNone
    std::vector<float> group_radius;          ///< [F] as in Partition
};

/// Finds patches of faces, each about 1/64 of a shared map, on which the search of a group map
/// can end within its limiting radius: that of some point exceeds the filter radius that the fewest
/// photons a map may have would give it, docs/partition_file.md (3) and (5).
/// out: of all faces of the mesh, kNone and 0 at those of the map; what is found is set.
/// Near linear, parallel over patches; the same at any thread count, whatever other maps there are.
void find_group_candidates(const MapTree& map, double position_error, GroupCandidates& out);

} // namespace hipmap
