#pragma once

#include "render/maps/wide_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace hipmap {

/// A search of a tree.
struct TreeQuery {
    glm::vec3 point;                                        ///< scene units, finite
    std::size_t photons;                                    ///< k, the most wanted, >= 1
    float radius2 = std::numeric_limits<float>::infinity(); ///< nothing farther counts
    TreeNode from = {};                   ///< begins there: photons outside it may be missed
    const std::uint32_t* order = nullptr; ///< [n] by slot: of equally near photons those that come
                                          ///< first in it count as nearer; none: by slot
};

/// Scratch memory of one thread for its searches; it grows and is reused.  It remembers the last
/// search, which makes a near one faster but never changes what is found.
struct TreeScratch {
    struct alignas(64) Row {
        float distance2[kTreeWidth];
    };
    std::vector<std::uint32_t> parents; ///< nodes that the kept ball touches, of one level
    std::vector<std::uint32_t> nodes;   ///< the same of the next; then leaf nodes
    std::size_t kept = 0;               ///< leaf nodes in use
    std::vector<std::uint32_t> blocks;  ///< that the ball touches, in tree order
    std::vector<Row> rows;              ///< square distances of their photons
    std::size_t filled = 0;             ///< blocks and rows in use
    std::vector<std::uint32_t> whole;   ///< blocks all of whose photons are nearer than the k-th
    std::size_t wholes = 0;             ///< of them in use
    std::size_t in_wholes = 0;          ///< their photons
    std::array<std::vector<std::uint32_t>, 3> rings; ///< nodes or blocks within some of the radii
    std::vector<float> band;                         ///< square distances among which the k-th is
    std::size_t in_band = 0;                         ///< values in use
    std::vector<std::uint32_t> found;                ///< slots
    std::vector<std::uint32_t> ties;                 ///< slots as far as the k-th

    std::uint64_t last_tree = 0; ///< its number
    glm::vec3 last_point{0.0f};
    float last_radius = 0.0f;    ///< of the last k-th photon; infinite if there were fewer
    bool last_missed = false;    ///< photons outside the node where it began may be nearer
    float drift = 1.0f;          ///< by how much the radius has lately changed for a step of 1
    std::uint64_t kept_tree = 0; ///< its number
    TreeNode kept_from;          ///< of it
    glm::vec3 kept_point{0.0f};
    float kept_radius = 0.0f; ///< all leaf nodes so near are kept
};

/// The slots that a search found; valid until its scratch is used again.
struct FoundSlots {
    std::span<std::uint32_t> slots; ///< by slot, save that the farthest comes last
    float farthest2 = 0.0f;         ///< square distance of the last
};

/// Lets every photon through.
struct AcceptAll {
    bool operator()(const auto&...) const { return true; }
};

/// The steps of find_nearest.
namespace tree_search {

/// Returns whether comparisons with the point are meaningless.
inline bool is_nowhere(const glm::vec3& point)
{
    return std::isnan(point.x + point.y + point.z);
}

/// Returns how many photons a search can look at.
inline std::uint64_t most_photons(const WideTree& tree, const TreeQuery& query)
{
    return query.from.level == 0 ? tree.size : photons_below(tree, query.from);
}

/// Returns the square of the distance from which on no photon of the tree counts.
float limit2(const WideTree& tree, const TreeQuery& query);

/// Squares of two distances between which the k-th photon is likely to be, from the last searches
/// or from some photons near the point.
struct Bounds2 {
    float low2, high2;
    float surely2; ///< and of one that it does not exceed, by what was found
};
Bounds2 bounds2(const WideTree& tree, const TreeQuery& query, float most2, TreeScratch& scratch);

/// Returns the next bounds after some within which only `inside` of the k photons were; at most
/// `most2`.
Bounds2 wider(const TreeQuery& query, const Bounds2& bounds, std::size_t inside, float most2);

/// Fills blocks and rows with the photons within bounds.high2 and returns their number; puts those
/// not nearer than bounds.low2 into the band.
std::size_t collect(const WideTree& tree, const TreeQuery& query, const Bounds2& bounds,
                    TreeScratch& scratch);

/// Moves collected photons that `accept` rejects infinitely far away; returns how many are left.
template <typename Accept>
std::size_t drop_rejected(float radius2, const Accept& accept, TreeScratch& scratch)
{
    std::size_t left = 0;
    scratch.in_band = 0; // has rejected ones too
    for (std::size_t b = 0; b < scratch.filled; ++b)
        for (std::uint32_t lane = 0; lane < kTreeWidth; ++lane) {
            float& distance2 = scratch.rows[b].distance2[lane];
            if (!(distance2 <= radius2))
                continue;
            if (accept(kTreeWidth * scratch.blocks[b] + lane))
                ++left;
            else
                distance2 = std::numeric_limits<float>::infinity();
        }
    return left;
}

/// Returns the k nearest of the `inside` collected photons, or all if there are fewer.
FoundSlots select(const WideTree& tree, const TreeQuery& query, const Bounds2& bounds,
                  std::size_t inside, TreeScratch& scratch);

} // namespace tree_search

/// Finds the k nearest photons that `accept(slot)` lets through, fewer if there are no more within
/// the radius; of equally near ones those first in the order.  Exact, whatever the scratch
/// remembers, and in the same order on every processor.  Thread-safe with a scratch for each
/// thread. Cost: O(k + log n) typically; nothing is allocated once the scratch has grown.
template <typename Accept = AcceptAll>
FoundSlots find_nearest(const WideTree& tree, const TreeQuery& query, TreeScratch& scratch,
                        const Accept& accept = {})
{
    if (tree_search::is_nowhere(query.point))
        return {};
    const float most2 = tree_search::limit2(tree, query);
    tree_search::Bounds2 bounds = tree_search::bounds2(tree, query, most2, scratch);
    for (;;) {
        std::size_t inside = tree_search::collect(tree, query, bounds, scratch);
        const bool all = inside >= tree_search::most_photons(tree, query);
        if constexpr (!std::is_same_v<Accept, AcceptAll>)
            inside = tree_search::drop_rejected(bounds.high2, accept, scratch);
        if (inside >= query.photons || all || !(bounds.high2 < most2))
            return tree_search::select(tree, query, bounds, inside, scratch);
        bounds = tree_search::wider(query, bounds, inside, most2);
    }
}

/// A photon by its slot, and how far it is.
struct NearPhoton {
    std::uint32_t slot;
    float distance2;
};

/// Returns a photon near the point, mostly the nearest: the nearest of the block reached by the
/// nearest box on each level.  A function of tree and point alone, the same on every processor. The
/// tree must not be empty; the point must be finite.  Thread-safe.  Cost: one node on each level.
NearPhoton near_photon(const WideTree& tree, const glm::vec3& point);

/// Lists the kernels that this processor can run, best first: "AVX3", "AVX2", "SSE4", ...
std::vector<const char*> simd_targets();

/// Makes all threads use one of simd_targets(); for tests and measurements.  Returns false if there
/// is no such target.
bool use_simd_target(const char* name);

} // namespace hipmap
