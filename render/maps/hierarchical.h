#pragma once

#include "render/maps/photon_maps.h"

#include <string>

namespace hipmap {

/// Plans the local and the group tier of mode hierarchical from the shared maps,
/// docs/photon_maps.md (8), and keeps the maps of those that are used.  Same maps, same plan, at
/// any thread count. Cost: a pass over the photons, and searches for some 1000 of them.  No
/// photons: no tiers.
void build_tiers(PhotonMaps& maps, const TriangleMesh& mesh, const Partition& partition);

/// Why a tier is used or not, in a few words with the figures.
std::string describe_plan(const TierPlan& plan);

/// A node of a tree.
struct TreeNode {
    std::uint32_t level = 0; ///< 0: the root
    std::uint64_t number = 0;
};

/// The lowest node that holds the slots from `low` to `high`, which are photons of the tree.
TreeNode lowest_node(const WideTree& tree, std::uint64_t low, std::uint64_t high);

/// Slot of the first photon of a node.
std::uint64_t first_slot(const WideTree& tree, const TreeNode& node);

/// The node and all below it as a tree of its own; slots count from first_slot.
WideTree part_of_tree(const WideTree& tree, const TreeNode& node);

} // namespace hipmap
