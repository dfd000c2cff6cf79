#pragma once

#include "preprocess/partition/face_tree.h"
#include "preprocess/partition/share_maps.h"

namespace hipmap {

struct GroupCandidates {
    std::vector<std::uint32_t> group_of_face; ///< [F] as in Partition
    std::vector<float> group_radius;          ///< [F] as in Partition
    std::uint32_t count = 0;                  ///< ids are 0..count-1 by lowest face
};

/// Finds patches of faces, each about 1/64 of its shared map, on which the search of a group map
/// can end within its limiting radius: that of some point exceeds the filter radius that the fewest
/// photons a map may have would give it, docs/partition_file.md (3) and (5).
/// tree: all faces that have a map.
/// Near linear, parallel over patches; the same at any thread count.
GroupCandidates find_group_candidates(const TriangleMesh& mesh, const SharedMaps& maps,
                                      const FaceTree& tree, double position_error);

} // namespace hipmap
