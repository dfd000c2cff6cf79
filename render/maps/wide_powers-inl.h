// What the kernels that add powers share; included once for each instruction set.

#if defined(HIPMAP_RENDER_MAPS_WIDE_POWERS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef HIPMAP_RENDER_MAPS_WIDE_POWERS_INL_H
#undef HIPMAP_RENDER_MAPS_WIDE_POWERS_INL_H
#else
#define HIPMAP_RENDER_MAPS_WIDE_POWERS_INL_H
#endif

#include "render/maps/photon_powers.h"
#include "render/maps/wide_simd-inl.h"

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

} // namespace hipmap::tree_search::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
