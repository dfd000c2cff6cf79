#include "render/maps/wide_sums.h"

#include "render/maps/wide_kernels.h"

// foreach_target compiles what follows it once for each instruction set.
// clang-format off
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/maps/wide_sums.cpp"
#include <hwy/foreach_target.h>
#include "render/maps/wide_blocks-inl.h"
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace hipmap::tree_search::HWY_NAMESPACE {

using WordVec = hn::Vec<Words>;
using Halves = hn::Rebind<std::uint16_t, Words>;

/// Twice as many blocks can be added to a sum of 32 bits.
constexpr std::size_t kChunk = 2048;

/// Sums of a chunk by lane and channel.
struct LaneSums {
    WordVec red, green, blue;
};

HWY_INLINE LaneSums no_sums()
{
    const WordVec zero = hn::Zero(Words());
    return {zero, zero, zero};
}

HWY_INLINE WordVec load_powers(const PowerBlock& block, int channel, std::size_t lane)
{
    return hn::PromoteTo(Words(), hn::Load(Halves(), block.power[channel] + lane));
}

HWY_INLINE WordVec keep(Mask mask, WordVec powers)
{
    return hn::IfThenElseZero(hn::RebindMask(Words(), mask), powers);
}

HWY_INLINE std::uint64_t sum_lanes(WordVec lanes)
{
#if HWY_TARGET == HWY_SCALAR
    return hn::GetLane(lanes);
#else
    const hn::Repartition<std::uint64_t, Words> wide;
    const auto pairs = hn::BitCast(wide, lanes);
    const auto low = hn::And(pairs, hn::Set(wide, 0xffffffffu));
    return hn::GetLane(hn::SumOfLanes(wide, hn::Add(low, hn::ShiftRight<32>(pairs))));
#endif
}

HWY_INLINE PowerSum total(const LaneSums& sums)
{
    return {sum_lanes(sums.red), sum_lanes(sums.green), sum_lanes(sums.blue)};
}

/// The photons of whole blocks, of which there are at most kChunk.
HWY_INLINE void add_blocks(const PhotonPowers& powers, std::span<const std::uint32_t> blocks,
                           LaneSums& sums)
{
    const PowerBlock* const all = powers.blocks.data();
    for (const std::uint32_t block : blocks)
        for (std::size_t lane = 0; lane < kTreeWidth; lane += hn::Lanes(Words())) {
            sums.red = hn::Add(sums.red, load_powers(all[block], 0, lane));
            sums.green = hn::Add(sums.green, load_powers(all[block], 1, lane));
            sums.blue = hn::Add(sums.blue, load_powers(all[block], 2, lane));
        }
}

/// The part of `items` that is the chunk from `begin` on.
template <typename T>
HWY_INLINE std::span<const T> chunk_of(std::span<const T> items, std::size_t begin)
{
    begin = HWY_MIN(begin, items.size());
    return items.subspan(begin, HWY_MIN(kChunk, items.size() - begin));
}

/// Adds one to the lanes in the mask.
HWY_INLINE WordVec count_lanes(WordVec count, Mask mask)
{
    return hn::Add(count, keep(mask, hn::Set(Words(), 1)));
}

HWY_INLINE void add_lanes(const PowerBlock& block, std::size_t lane, Mask mask, LaneSums& sums)
{
    sums.red = hn::Add(sums.red, keep(mask, load_powers(block, 0, lane)));
    sums.green = hn::Add(sums.green, keep(mask, load_powers(block, 1, lane)));
    sums.blue = hn::Add(sums.blue, keep(mask, load_powers(block, 2, lane)));
}

NearerSum SumNearer(const PhotonPowers& powers, float farthest2, const TreeScratch& scratch)
{
    const Floats d;
    const FloatVec farthest = hn::Set(d, farthest2);
    const PowerBlock* const all = powers.blocks.data();
    const std::span<const std::uint32_t> whole(scratch.whole.data(), scratch.wholes);
    const std::span<const std::uint32_t> others(scratch.blocks.data(), scratch.filled);
    const TreeScratch::Row* row = scratch.rows.data();
    NearerSum out{PowerSum(0), scratch.in_wholes};
    for (std::size_t begin = 0; begin < HWY_MAX(whole.size(), others.size()); begin += kChunk) {
        LaneSums sums = no_sums();
        add_blocks(powers, chunk_of(whole, begin), sums);
        WordVec count = hn::Zero(Words());
        for (const std::uint32_t block : chunk_of(others, begin)) {
            for (std::size_t lane = 0; lane < kTreeWidth; lane += hn::Lanes(d)) {
                const Mask nearer = hn::Lt(hn::Load(d, row->distance2 + lane), farthest);
                count = count_lanes(count, nearer);
                add_lanes(all[block], lane, nearer, sums);
            }
            ++row;
        }
        out.power += total(sums);
        out.nearer += sum_lanes(count);
    }
    return out;
}

/// Balls about one point.
template <std::size_t n>
struct Balls {
    PointVec point;
    const std::array<float, n>& radii2; ///< descending
};

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
                              const Balls<n>& balls, TreeScratch& scratch, RingCounts<n>& count)
{
    const Floats d;
    for (std::uint32_t lane = 0; lane < kTreeWidth; lane += hn::Lanes(d)) {
        const BoxDistances2 box = box_distances2(boxes, lane, balls.point);
        Mask crossed = hn::Le(box.nearest, hn::Set(d, balls.radii2[0]));
        for (std::size_t r = 0; r < n; ++r) {
            Mask ring = hn::Le(box.farthest, hn::Set(d, balls.radii2[r]));
            if (r + 1 < n)
                ring = hn::And(ring, hn::Gt(box.nearest, hn::Set(d, balls.radii2[r + 1])));
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
                                    const Balls<n>& balls, TreeScratch& scratch)
{
    const std::size_t most = kTreeWidth * (parents + 1);
    grow(scratch.blocks, most);
    for (std::size_t r = 0; r < n; ++r)
        grow(scratch.rings[r], most);
    RingCounts<n> count;
    for (std::size_t i = 0; i < parents; ++i) {
        const std::uint32_t node = scratch.parents[i];
        sort_children(tree.nodes[tree.first_node[level] + node], kTreeWidth * node, balls, scratch,
                      count);
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

/// Adds the photons within each of the balls, of blocks that their boundaries may cross.
template <std::size_t n>
HWY_INLINE void add_crossed(const WideTree& tree, const PhotonPowers& powers, const Balls<n>& balls,
                            std::span<const std::uint32_t> crossed, RadiusSums<n>& out)
{
    const Floats d;
    for (std::size_t begin = 0; begin < crossed.size(); begin += kChunk) {
        LaneSums sums[n];
        WordVec counts[n];
        for (std::size_t r = 0; r < n; ++r) {
            sums[r] = no_sums();
            counts[r] = hn::Zero(Words());
        }
        for (const std::uint32_t block : chunk_of(crossed, begin))
            for (std::size_t lane = 0; lane < kTreeWidth; lane += hn::Lanes(d)) {
                const FloatVec distance2 = photon_distance2(tree.blocks[block], lane, balls.point);
                for (std::size_t r = 0; r < n; ++r) {
                    const Mask within = hn::Le(distance2, hn::Set(d, balls.radii2[r]));
                    counts[r] = count_lanes(counts[r], within);
                    add_lanes(powers.blocks[block], lane, within, sums[r]);
                }
            }
        for (std::size_t r = 0; r < n; ++r) {
            out[r].power += total(sums[r]);
            out[r].photons += sum_lanes(counts[r]);
        }
    }
}

/// Adds the photons of the blocks in the rings.
template <std::size_t n>
HWY_INLINE void add_rings(const WideTree& tree, const PhotonPowers& powers,
                          const RingCounts<n>& count, const TreeScratch& scratch,
                          RadiusSums<n>& out)
{
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
    const Balls<n> balls{spread(at), radii2};
    grow(scratch.parents, kTreeWidth);
    scratch.parents[0] = 0;
    RingCounts<n> count;
    count.crossed = 1;
    for (std::uint32_t level = 0; level + 1 < tree.levels; ++level) {
        count = sort_level(tree, level, count.crossed, balls, scratch);
        for (std::size_t r = 0; r < n; ++r)
            for (std::size_t i = 0; i < count.ring[r]; ++i) {
                const std::uint32_t node = scratch.rings[r][i];
                add_to_rings({powers.nodes[tree.first_node[level + 1] + node],
                              photons_below(tree, {level + 1, node})},
                             r, out);
            }
        scratch.parents.swap(scratch.blocks);
    }
    count = sort_level(tree, tree.levels - 1, count.crossed, balls, scratch);
    add_crossed(tree, powers, balls, {scratch.blocks.data(), count.crossed}, out);
    add_rings(tree, powers, count, scratch, out);
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

HWY_EXPORT(SumNearer);
HWY_EXPORT(SumWithin1);
HWY_EXPORT(SumWithin3);

NearerSum sum_nearer(const PhotonPowers& powers, float farthest2, const TreeScratch& scratch)
{
    return HWY_DYNAMIC_DISPATCH(SumNearer)(powers, farthest2, scratch);
}

namespace {

/// Sums the first `count` photons that are exactly as far.
PowerSum sum_ties(const PhotonPowers& powers, const TreeQuery& query, float farthest2,
                  std::size_t count, TreeScratch& scratch)
{
    PowerSum sum(0);
    const std::size_t ties = emit_nearest(farthest2, scratch).as_far;
    for (const std::uint32_t slot : ties_in_order(query, ties, scratch).first(count))
        sum += powers.of(slot);
    return sum;
}

} // namespace

} // namespace tree_search

NearestSum sum_nearest(const WideTree& tree, const PhotonPowers& powers, const TreeQuery& query,
                       TreeScratch& scratch)
{
    using namespace tree_search;
    if (is_nowhere(query.point))
        return {};
    const std::size_t k = query.photons;
    const float most2 = limit2(tree, query);
    Bounds2 bounds = bounds2(tree, query, most2, scratch);
    std::size_t inside = 0;
    for (;;) {
        inside = collect_shell(tree, query, bounds, scratch);
        if (inside - scratch.in_band >= k)
            bounds.low2 = 0.0f; // the k-th is nearer than was thought
        else if (inside >= k || inside >= most_photons(tree, query) || !(bounds.high2 < most2))
            break;
        else
            bounds = wider(query, bounds, inside, most2);
    }
    NearestSum out;
    out.photons = std::min(k, inside);
    if (inside > 0) {
        out.farthest2 = kth_of_collected(k, bounds, inside, scratch);
        const std::size_t wanted = inside < k ? inside : k - 1;
        const NearerSum nearer = sum_nearer(powers, out.farthest2, scratch);
        out.power = nearer.power;
        if (nearer.nearer < wanted)
            out.power += sum_ties(powers, query, out.farthest2, wanted - nearer.nearer, scratch);
    }
    remember(tree, query, out.photons, out.farthest2, scratch);
    return out;
}

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
