#include "render/maps/packed_direction.h"

#include <bit>
#include <cassert>

// foreach_target compiles what follows it once for each instruction set.
// clang-format off
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/maps/packed_direction.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace hipmap::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Unpacks the directions in words of u and v, with the operations of unpack_direction.
void UnpackWords(const std::int32_t* words, std::size_t count, DirectionBatch& out)
{
    const hn::CappedTag<float, 16> d;
    const hn::RebindToSigned<decltype(d)> whole;
    const auto one = hn::Set(d, 1.0f), largest = hn::Set(d, 32767.0f);
    for (std::size_t lane = 0; lane < count; lane += hn::Lanes(d)) {
        const auto packed = hn::Load(whole, words + lane);
        const auto low = hn::ShiftRight<16>(hn::ShiftLeft<16>(packed));
        const auto u = hn::Div(hn::ConvertTo(d, low), largest);
        const auto v = hn::Div(hn::ConvertTo(d, hn::ShiftRight<16>(packed)), largest);
        const auto z = hn::Sub(hn::Sub(one, hn::Abs(u)), hn::Abs(v));
        const auto lower = hn::Lt(z, hn::Zero(d));
        const auto x = hn::IfThenElse(lower, hn::CopySign(hn::Sub(one, hn::Abs(v)), u), u);
        const auto y = hn::IfThenElse(lower, hn::CopySign(hn::Sub(one, hn::Abs(u)), v), v);
        const auto length2 = hn::Add(hn::Add(hn::Mul(x, x), hn::Mul(y, y)), hn::Mul(z, z));
        const auto shorten = hn::Div(one, hn::Sqrt(length2));
        hn::Store(hn::Mul(x, shorten), d, &out.x[lane]);
        hn::Store(hn::Mul(y, shorten), d, &out.y[lane]);
        hn::Store(hn::Mul(z, shorten), d, &out.z[lane]);
    }
}

} // namespace hipmap::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hipmap {

HWY_EXPORT(UnpackWords);

void unpack_directions(std::span<const PackedDirection> directions,
                       std::span<const std::uint32_t> slots, DirectionBatch& out)
{
    assert(!slots.empty() && slots.size() <= kBatch);
    alignas(64) std::array<std::int32_t, kBatch> words;
    for (std::size_t i = 0; i < slots.size(); ++i)
        words[i] = std::bit_cast<std::int32_t>(directions[slots[i]]);
    for (std::size_t i = slots.size(); i % 16 != 0; ++i)
        words[i] = 0;
    HWY_DYNAMIC_DISPATCH(UnpackWords)(words.data(), slots.size(), out);
}

} // namespace hipmap
#endif
