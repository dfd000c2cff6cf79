#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace hipmap {

/// The number of photons of a block, and of children of a node.
inline constexpr std::uint32_t kTreeWidth = 16;

/// A point from which a tree is built.
struct TreePoint {
    glm::vec3 position;   ///< scene units
    std::uint32_t photon; ///< the caller's number
};

/// Photons that lie together; lanes without one are infinitely far.
struct alignas(64) PhotonBlock {
    float position[3][kTreeWidth];
};

/// The boxes of a node's children; a missing child has low +inf and high -inf.
struct alignas(64) BoxNode {
    float low[3][kTreeWidth];
    float high[3][kTreeWidth];
};

/// A tree of boxes, 16 children to a node, over blocks of 16 photons, docs/photon_maps.md.  It has
/// no pointers: child j of node i of a level is node (or block) 16 i + j of the next.  A photon's
/// slot is its place in the order of the blocks.  About 13.6 bytes a photon. Read-only once built:
/// any number of threads may search.
struct WideTree {
    std::uint64_t number = 0;                  ///< that no other tree has, save its copies
    std::uint64_t size = 0;                    ///< photons
    std::vector<PhotonBlock> blocks;           ///< all but the last are full
    std::vector<BoxNode> nodes;                ///< the root, then level by level
    std::array<std::uint32_t, 7> first_node{}; ///< of each level
    std::uint32_t levels = 0;
    glm::vec3 low{0.0f}, high{0.0f}; ///< box of all photons

    glm::vec3 position(std::uint32_t slot) const
    {
        const PhotonBlock& block = blocks[slot / kTreeWidth];
        const std::uint32_t lane = slot % kTreeWidth;
        return {block.position[0][lane], block.position[1][lane], block.position[2][lane]};
    }
    /// Returns the bytes of the arrays.
    std::size_t bytes() const
    {
        return blocks.size() * sizeof(PhotonBlock) + nodes.size() * sizeof(BoxNode);
    }
};

/// A node of a tree.
struct TreeNode {
    std::uint32_t level = 0; ///< 0: the root
    std::uint64_t number = 0;
    bool operator==(const TreeNode&) const = default;
};

/// Returns the slot of the first photon of a node.
std::uint64_t first_slot(const WideTree& tree, const TreeNode& node);

/// Returns how many photons a node holds.
std::uint64_t photons_below(const WideTree& tree, const TreeNode& node);

/// Returns the lowest node that holds the slots from `low` to `high`, which are photons of the
/// tree.
TreeNode lowest_node(const WideTree& tree, std::uint64_t low, std::uint64_t high);

/// Sorts `points` by slot and builds their tree, in parallel.  O(n log n). Same points in the same
/// order, same tree, at any thread count.  Positions must be finite and below 1e18, points fewer
/// than 2^32.  No points: a tree that finds nothing.
WideTree build_wide_tree(std::span<TreePoint> points);

/// One photon in this many gets a radius of its own: the photons between them have nearly the same
/// neighbours.
inline constexpr std::uint32_t kPhotonsOfRadius = 4;

/// Returns one of every n photons by slot, n >= 1.  Slots lie in the order of the tree, so that the
/// result is spread as all photons are; it takes them in turn from each place among n, as the
/// photons of a block are sorted along an axis.  `photon` is the slot.
std::vector<TreePoint> every_nth_photon(const WideTree& tree, std::uint32_t n);

/// Builds the blocks alone, in the order of the points: for positions by slot where another
/// structure is searched.
WideTree build_blocks(std::span<const TreePoint> points);

} // namespace hipmap
