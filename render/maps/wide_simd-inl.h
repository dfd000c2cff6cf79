// What the kernels of the wide tree share; included once for each instruction set.

#if defined(HIPMAP_RENDER_MAPS_WIDE_SIMD_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef HIPMAP_RENDER_MAPS_WIDE_SIMD_INL_H
#undef HIPMAP_RENDER_MAPS_WIDE_SIMD_INL_H
#else
#define HIPMAP_RENDER_MAPS_WIDE_SIMD_INL_H
#endif

#include "render/maps/wide_search.h"

#include <hwy/highway.h>

#include <array>

HWY_BEFORE_NAMESPACE();
namespace hipmap::tree_search::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, kTreeWidth>;
using Words = hn::RebindToUnsigned<Floats>;
using FloatVec = hn::Vec<Floats>;
using Mask = hn::Mask<Floats>;

/// Lists, for each mask of 8 bits, the places of the set bits.
constexpr auto set_bits()
{
    std::array<std::array<std::uint8_t, 8>, 256> places{};
    for (unsigned mask = 0; mask < 256; ++mask)
        for (std::uint8_t bit = 0, count = 0; bit < 8; ++bit)
            if ((mask >> bit & 1) != 0)
                places[mask][count++] = bit;
    return places;
}

/// Moves the lanes in the mask to the front.  Replaces Highway's own for 4 and 8 lanes, whose table
/// GCC copies to the stack at every call.
template <class V>
HWY_INLINE V squeeze(V v, Mask mask)
{
    const Floats d;
    if constexpr (hn::MaxLanes(d) == 4 || hn::MaxLanes(d) == 8) {
        alignas(64) static constexpr auto kPlaces = set_bits();
        std::uint8_t bits[8] = {};
        hn::StoreMaskBits(d, mask, bits);
        const hn::Rebind<std::uint8_t, Floats> bytes;
        const hn::DFromV<V> same;
        const auto places = hn::PromoteTo(Words(), hn::LoadU(bytes, kPlaces[bits[0]].data()));
        return hn::TableLookupLanes(v, hn::IndicesFromVec(same, places));
    } else {
        return hn::Compress(v, hn::RebindMask(hn::DFromV<V>(), mask));
    }
}

/// Writes the numbers from `first` on of the lanes in the mask, and returns how many; up to a whole
/// vector is written.
HWY_INLINE std::size_t write_lanes(std::uint32_t first, Mask mask, std::uint32_t* out)
{
    alignas(64) static constexpr std::uint32_t kLanes[] = {0, 1, 2,  3,  4,  5,  6,  7,
                                                           8, 9, 10, 11, 12, 13, 14, 15};
    const Words d;
    const auto numbers = hn::Add(hn::Load(d, kLanes), hn::Set(d, first));
    hn::StoreU(squeeze(numbers, mask), d, out);
    return hn::CountTrue(Floats(), mask);
}

/// Writes the values of the lanes in the mask, and returns how many; up to a whole vector is
/// written.
HWY_INLINE std::size_t write_values(FloatVec values, Mask mask, float* out)
{
    hn::StoreU(squeeze(values, mask), Floats(), out);
    return hn::CountTrue(Floats(), mask);
}

/// Writes 16 infinities.
HWY_INLINE void pad(float* out)
{
    const Floats d;
    for (std::size_t lane = 0; lane < kTreeWidth; lane += hn::Lanes(d))
        hn::StoreU(hn::Set(d, std::numeric_limits<float>::infinity()), d, out + lane);
}

template <typename T>
HWY_INLINE void grow(std::vector<T>& storage, std::size_t size)
{
    if (HWY_UNLIKELY(storage.size() < size))
        storage.resize(size + size / 2);
}

} // namespace hipmap::tree_search::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
