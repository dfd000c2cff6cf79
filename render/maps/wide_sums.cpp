#include "render/maps/wide_sums.h"

#include "render/maps/wide_kernels.h"

// foreach_target compiles what follows it once for each instruction set.
// clang-format off
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/maps/wide_sums.cpp"
#include <hwy/foreach_target.h>
#include "render/maps/wide_blocks-inl.h"
#include "render/maps/wide_powers-inl.h"
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace hipmap::tree_search::HWY_NAMESPACE {

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

} // namespace hipmap::tree_search::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hipmap {

namespace tree_search {

HWY_EXPORT(SumNearer);

NearerSum sum_nearer(const PhotonPowers& powers, float farthest2, const TreeScratch& scratch)
{
    return HWY_DYNAMIC_DISPATCH(SumNearer)(powers, farthest2, scratch);
}

namespace {

/// Of the first `count` photons that are exactly as far.
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

} // namespace hipmap
#endif
