#pragma once

#include "common/partition/partition.h"
#include "common/scene/mesh.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace hipmap {

/// The number of faces of a block, and of children of a node.
inline constexpr std::uint32_t kFoldWidth = 8;

/// Faces that lie together.  Lanes without one are a point of the block.
struct alignas(32) FoldBlock {
    float corner[3][3][kFoldWidth]; ///< [corner][axis], anticlockwise as side 0 sees them
};

/// The sums of its children's faces.  Those that look along +x, -x, +y, -y, +z and -z most are
/// summed apart, so that the two sides of a thin sheet may share a child.
struct alignas(32) FoldNode {
    static constexpr std::size_t kDirections = 6;

    float low[3][kFoldWidth], high[3][kFoldWidth]; ///< a missing child: low +inf, high -inf
    float middle[3][kFoldWidth];                   ///< of the area
    float variance[3][kFoldWidth];                 ///< of its place: xx, yy, zz
    float covariance[3][kFoldWidth];               ///< yz, zx, xy
    float area[kDirections][kFoldWidth];           ///< square scene units
    /// [axis] means of the unit normals, weighted by area; not of unit length
    float normal[kDirections][3][kFoldWidth];
    std::uint32_t first_child; ///< the others follow it
    bool of_blocks;            ///< the children are blocks
};

/// A node or a block.
struct FoldPlace {
    std::uint32_t number;
    bool is_block;
};

/// Trees over the faces of maps.
struct FoldTrees {
    std::vector<FoldBlock> blocks;
    std::vector<FoldNode> nodes;
    std::vector<FoldPlace> roots; ///< [trees]
};

/// Builds a tree for each map that folds, in parallel.  fold_of: [maps of stored faces] its tree,
/// numbered from 0 on; kNone: it does not fold.  The same trees at any thread count.  Cost: O(n log
/// n), and about 60 bytes for each face of such maps.
FoldTrees build_fold_trees(const TriangleMesh& mesh, const Partition& partition,
                           std::span<const std::uint32_t> fold_of);

} // namespace hipmap
