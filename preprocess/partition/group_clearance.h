#pragma once

#include "preprocess/partition/face_tree.h"
#include "preprocess/partition/share_maps.h"

namespace hipmap {

/// What a search for the faces around a patch goes through.
struct PatchSurroundings {
    const TriangleMesh& mesh;
    const FaceTree& tree; ///< all faces that have a map
    std::span<const MapId> map_of_face;
    std::span<const std::uint32_t> patch_of_face;
    std::vector<MapId> map_of_node; ///< kNone where a node's faces differ
    std::vector<std::uint32_t> patch_of_node;
};

/// How far the centres of a patch's faces are from the faces of its map outside it, D of
/// docs/partition_file.md (5): never more than it is, and less by at most `slack`.  Scene units.
/// All 0 where other maps lie so thick through the patch that finding it would take too long.
/// faces: all of the patch, not empty.  Returns a distance for each.
/// One search of O(log n) for each stretch of faces whose centres lie within about `slack`, so that
/// neighbours had better follow each other.
std::vector<double> clearances_of_patch(const PatchSurroundings& around,
                                        std::span<const FaceId> faces, double slack);

} // namespace hipmap
