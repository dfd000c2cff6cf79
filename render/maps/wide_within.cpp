#include "render/maps/wide_kernels.h"
#include "render/maps/wide_sums.h"

// foreach_target compiles what follows it once for each instruction set.
// clang-format off
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/maps/wide_within.cpp"
#include <hwy/foreach_target.h>
#include "render/maps/wide_blocks-inl.h"
#include "render/maps/wide_powers-inl.h"
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace hipmap::tree_search::HWY_NAMESPACE {

/// Children of nodes: those within the balls 0 to r and outside the others, by r, and those that
/// the boundary of a ball may cross.
template <std::size_t n>
struct RingCounts {
    std::array<std::size_t, n> ring{};
    std::size_t crossed = 0;
};

/// Writes the children of a node that the boundary of a ball may cross to `crossed`, and those
/// within the balls 0 to r that are outside the others to ring r; adds their numbers to the counts.
template <std::size_t n>
HWY_INLINE void sort_children(const BoxNode& boxes, std::uint32_t first_child,
                              const PointVec& point, const std::array<float, n>& radii2,
                              TreeScratch& scratch, RingCounts<n>& count)
{
    const Floats d;
    for (std::uint32_t lane = 0; lane < kTreeWidth; lane += hn::Lanes(d)) {
        const BoxDistances2 box = box_distances2(boxes, lane, point);
        Mask crossed = hn::Le(box.nearest, hn::Set(d, radii2[0]));
        for (std::size_t r = 0; r < n; ++r) {
            Mask ring = hn::Le(box.farthest, hn::Set(d, radii2[r]));
            if (r + 1 < n)
                ring = hn::And(ring, hn::Gt(box.nearest, hn::Set(d, radii2[r + 1])));
            crossed = hn::AndNot(ring, crossed);
            if (!hn::AllFalse(d, ring))
                count.ring[r] +=
                    write_lanes(first_child + lane, ring, scratch.rings[r].data() + count.ring[r]);
        }
        count.crossed +=
            write_lanes(first_child + lane, crossed, scratch.blocks.data() + count.crossed);
    }
}

/// Sorts the children of the first `parents` nodes in scratch.parents.
template <std::size_t n>
HWY_INLINE RingCounts<n> sort_level(const WideTree& tree, std::uint32_t level, std::size_t parents,
                                    const PointVec& point, const std::array<float, n>& radii2,
                                    TreeScratch& scratch)
{
    const std::size_t most = kTreeWidth * (parents + 1);
    grow(scratch.blocks, most);
    for (std::size_t r = 0; r < n; ++r)
        grow(scratch.rings[r], most);
    RingCounts<n> count;
    for (std::size_t i = 0; i < parents; ++i) {
        const std::uint32_t node = scratch.parents[i];
        sort_children(tree.nodes[tree.first_node[level] + node], kTreeWidth * node, point, radii2,
                      scratch, count);
    }
    return count;
}

template <std::size_t n>
HWY_INLINE void add_to_rings(const RadiusSum& sum, std::size_t ring, RadiusSums<n>& out)
{
    for (std::size_t r = 0; r <= ring; ++r) {
        out[r].power += sum.power;
        out[r].photons += sum.photons;
    }
}

/// Adds the photons of the blocks in scratch.blocks and in the rings.
template <std::size_t n>
HWY_INLINE void measure_blocks(const WideTree& tree, const PhotonPowers& powers,
                               const PointVec& point, const std::array<float, n>& radii2,
                               const RingCounts<n>& count, const TreeScratch& scratch,
                               RadiusSums<n>& out)
{
    const Floats d;
    const std::span<const std::uint32_t> crossed(scratch.blocks.data(), count.crossed);
    for (std::size_t begin = 0; begin < crossed.size(); begin += kChunk) {
        LaneSums sums[n];
        WordVec counts[n];
        for (std::size_t r = 0; r < n; ++r) {
            sums[r] = no_sums();
            counts[r] = hn::Zero(Words());
        }
        for (const std::uint32_t block : chunk_of(crossed, begin))
            for (std::size_t lane = 0; lane < kTreeWidth; lane += hn::Lanes(d)) {
                const FloatVec distance2 = photon_distance2(tree.blocks[block], lane, point);
                for (std::size_t r = 0; r < n; ++r) {
                    const Mask within = hn::Le(distance2, hn::Set(d, radii2[r]));
                    counts[r] = count_lanes(counts[r], within);
                    add_lanes(powers.blocks[block], lane, within, sums[r]);
                }
            }
        for (std::size_t r = 0; r < n; ++r) {
            out[r].power += total(sums[r]);
            out[r].photons += sum_lanes(counts[r]);
        }
    }
    for (std::size_t r = 0; r < n; ++r) {
        const std::span<const std::uint32_t> ring(scratch.rings[r].data(), count.ring[r]);
        for (std::size_t begin = 0; begin < ring.size(); begin += kChunk) {
            LaneSums sums = no_sums();
            add_blocks(powers, chunk_of(ring, begin), sums);
            add_to_rings({total(sums), photons_in(tree, chunk_of(ring, begin))}, r, out);
        }
    }
}

template <std::size_t n>
HWY_INLINE RadiusSums<n> sum_within_radii(const WideTree& tree, const PhotonPowers& powers,
                                          const glm::vec3& at, const std::array<float, n>& radii2,
                                          TreeScratch& scratch)
{
    RadiusSums<n> out;
    if (tree.size == 0)
        return out;
    const PointVec point = spread(at);
    grow(scratch.parents, kTreeWidth);
    scratch.parents[0] = 0;
    RingCounts<n> count;
    count.crossed = 1;
    for (std::uint32_t level = 0; level + 1 < tree.levels; ++level) {
        count = sort_level(tree, level, count.crossed, point, radii2, scratch);
        for (std::size_t r = 0; r < n; ++r)
            for (std::size_t i = 0; i < count.ring[r]; ++i) {
                const std::uint32_t node = scratch.rings[r][i];
                add_to_rings({powers.nodes[tree.first_node[level + 1] + node],
                              photons_below(tree, {level + 1, node})},
                             r, out);
            }
        scratch.parents.swap(scratch.blocks);
    }
    count = sort_level(tree, tree.levels - 1, count.crossed, point, radii2, scratch);
    measure_blocks(tree, powers, point, radii2, count, scratch, out);
    return out;
}

RadiusSums<1> SumWithin1(const WideTree& tree, const PhotonPowers& powers, const glm::vec3& point,
                         const std::array<float, 1>& radii2, TreeScratch& scratch)
{
    return sum_within_radii(tree, powers, point, radii2, scratch);
}

RadiusSums<3> SumWithin3(const WideTree& tree, const PhotonPowers& powers, const glm::vec3& point,
                         const std::array<float, 3>& radii2, TreeScratch& scratch)
{
    return sum_within_radii(tree, powers, point, radii2, scratch);
}

} // namespace hipmap::tree_search::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hipmap {

namespace tree_search {

HWY_EXPORT(SumWithin1);
HWY_EXPORT(SumWithin3);

} // namespace tree_search

RadiusSums<1> sum_within(const WideTree& tree, const PhotonPowers& powers, const glm::vec3& point,
                         const std::array<float, 1>& radii2, TreeScratch& scratch)
{
    using namespace tree_search;
    if (is_nowhere(point))
        return {};
    return HWY_DYNAMIC_DISPATCH(SumWithin1)(tree, powers, point, radii2, scratch);
}

RadiusSums<3> sum_within(const WideTree& tree, const PhotonPowers& powers, const glm::vec3& point,
                         const std::array<float, 3>& radii2, TreeScratch& scratch)
{
    using namespace tree_search;
    if (is_nowhere(point))
        return {};
    return HWY_DYNAMIC_DISPATCH(SumWithin3)(tree, powers, point, radii2, scratch);
}

} // namespace hipmap
#endif
