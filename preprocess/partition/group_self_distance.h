#pragma once

#include "preprocess/partition/patches.h"

namespace hipmap {

/// The data that a search for the faces around a patch walks through.
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

/// Returns the distance of each face centre of a patch from the faces of its map outside the patch,
/// D of docs/partition_file.md (5), in scene units: never too large, and too small by at most
/// `slack`. clumps: all of the patch, not empty.  Returns all faces of the patch, or none where it
/// would take too long. Cost: one search of O(log n) for each run of faces whose centres lie within
/// about `slack`, so neighbouring clumps should follow each other.
std::vector<FaceDistance> distances_of_patch(const PatchSurroundings& around,
                                             std::span<const Clump> clumps, double slack);

} // namespace hipmap
