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

/// So many blocks can be added to a sum of 32 bits.
constexpr std::size_t kChunk = 4096;

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
    HWY_ALIGN std::uint32_t values[kTreeWidth];
    hn::Store(lanes, Words(), values);
    std::uint64_t sum = 0;
    for (std::size_t lane = 0; lane < hn::Lanes(Words()); ++lane)
        sum += values[lane];
    return sum;
}

HWY_INLINE PowerSum total(const LaneSums& sums)
{
    return {sum_lanes(sums.red), sum_lanes(sums.green), sum_lanes(sums.blue)};
}

/// Calls `add(index)` for 0 to count - 1, and `flush()` before a sum could overflow and at the end.
template <typename Add, typename Flush>
HWY_INLINE void in_chunks(std::size_t count, const Add& add, const Flush& flush)
{
    for (std::size_t begin = 0; begin < count; begin += kChunk) {
        const std::size_t end = HWY_MIN(count, begin + kChunk);
        for (std::size_t i = begin; i < end; ++i)
            add(i);
        flush();
    }
}

/// Of whole blocks.
HWY_INLINE PowerSum sum_blocks(const PhotonPowers& powers, std::span<const std::uint32_t> blocks)
{
    PowerSum sum(0);
    LaneSums sums = no_sums();
    const auto add = [&](std::size_t i) HWY_ATTR {
        const PowerBlock& block = powers.blocks[blocks[i]];
        for (std::size_t lane = 0; lane < kTreeWidth; lane += hn::Lanes(Words())) {
            sums.red = hn::Add(sums.red, load_powers(block, 0, lane));
            sums.green = hn::Add(sums.green, load_powers(block, 1, lane));
            sums.blue = hn::Add(sums.blue, load_powers(block, 2, lane));
        }
    };
    const auto flush = [&]() HWY_ATTR {
        sum += total(sums);
        sums = no_sums();
    };
    in_chunks(blocks.size(), add, flush);
    return sum;
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
