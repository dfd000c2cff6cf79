#pragma once

#include "preprocess/partition/patches.h"

namespace hipmap {

/// What a search for the faces around a patch goes through.
struct PatchSurroundings {
    const TriangleMesh& mesh;
    const FaceTree& tree; ///< of the map
    std::span<const std::uint32_t> patch_of_face;
    std::vector<std::uint32_t> patch_of_node; ///< kNone where a node's faces differ
};

struct FaceDistance {
    FaceId face = kNone;
    double distance = 0.0; ///< scene units
};

/// How far the centres of a patch's faces are from the faces of its map outside it, D of
/// docs/partition_file.md (5): never more than it is, and less by at most `slack`.  Scene units.
/// clumps: all of the patch, not empty.  Returns all its faces, or none where it would take too
/// long.
/// One search of O(log n) for each stretch of faces whose centres lie within about `slack`, so that
/// neighbouring clumps had better follow each other.
std::vector<FaceDistance> distances_of_patch(const PatchSurroundings& around,
                                             std::span<const Clump> clumps, double slack);

} // namespace hipmap
