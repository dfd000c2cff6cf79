#pragma once

#include "render/maps/photon_powers.h"
#include "render/maps/wide_search.h"

namespace hipmap::tree_search {

/// A child of a node.  Not among the kernels, so that std::sort can inline its order.
struct Child {
    float distance2, corner2;
    std::size_t number; ///< on its level

    /// Nearer first; of several boxes round a point, the one whose farthest corner is nearest.
    bool operator<(const Child& other) const
    {
        return distance2 < other.distance2 ||
               (distance2 == other.distance2 && corner2 < other.corner2);
    }
};
/// Fills blocks and rows with at least k photons near the point, of which the k-th nearest bounds
/// the k-th of all, and returns their number.  query.from has more than k photons.
std::size_t collect_near(const WideTree& tree, const TreeQuery& query, TreeScratch& scratch);

/// Collects as `collect` does, but puts blocks that are wholly nearer than bounds.low2 into
/// scratch.whole instead; their photons count.
std::size_t collect_shell(const WideTree& tree, const TreeQuery& query, const Bounds2& bounds,
                          TreeScratch& scratch);

/// Returns the number of photons in some blocks, which are in ascending order.
inline std::size_t photons_in(const WideTree& tree, std::span<const std::uint32_t> blocks)
{
    const std::size_t slots = kTreeWidth * blocks.size();
    const bool has_last = !blocks.empty() && blocks.back() + 1 == tree.blocks.size();
    return has_last ? slots - (kTreeWidth * tree.blocks.size() - tree.size) : slots;
}

/// Powers and number of the photons in scratch.whole and of those collected nearer than
/// `farthest2`.
struct NearerSum {
    PowerSum power;
    std::size_t nearer;
};
NearerSum sum_nearer(const PhotonPowers& powers, float farthest2, const TreeScratch& scratch);

/// Returns the square distance of the k-th collected photon, or of the farthest if no more than k
/// are inside.
float kth_of_collected(std::size_t k, const Bounds2& bounds, std::size_t inside,
                       TreeScratch& scratch);

/// Sorts the `count` equally far slots into the query's order and returns them.
std::span<std::uint32_t> ties_in_order(const TreeQuery& query, std::size_t count,
                                       TreeScratch& scratch);

/// Remembers a search for the next one.  found: photons.
void remember(const WideTree& tree, const TreeQuery& query, std::size_t found, float farthest2,
              TreeScratch& scratch);

/// Returns the k-th smallest of the collected distances up to bounds.high2, of which there are
/// `inside` >= k.
float kth_distance2(std::size_t k, const Bounds2& bounds, std::size_t inside, TreeScratch& scratch);

/// Returns the greatest collected distance up to radius2; zero if there is none.
float greatest_distance2(float radius2, const TreeScratch& scratch);

/// Puts the collected slots nearer than `farthest2` into scratch.found, and those equally far into
/// scratch.ties.
struct Emitted {
    std::size_t nearer, as_far;
};
Emitted emit_nearest(float farthest2, TreeScratch& scratch);

} // namespace hipmap::tree_search
