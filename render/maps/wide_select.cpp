#include "render/maps/wide_kernels.h"

#include <bit>
#include <cmath>

// foreach_target compiles what follows it once for each instruction set.
// clang-format off
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/maps/wide_select.cpp"
#include <hwy/foreach_target.h>
#include "render/maps/wide_simd-inl.h"
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace hipmap::tree_search::HWY_NAMESPACE {

constexpr float kFar = std::numeric_limits<float>::infinity();

/// Values with low <= value < high: `count` of them, of which the k-th is wanted.
struct Bracket {
    float low, high;
    std::size_t count, k;
};

HWY_INLINE std::uint32_t bits(float value)
{
    return std::bit_cast<std::uint32_t>(value);
}

/// The part of the bracket where the k-th value is likely to be, were they spread evenly: photons
/// on a surface are, by their square distances.  After `kAims` passes the lower half of the
/// floating-point numbers in the bracket, which ends whatever the values are.
HWY_INLINE Bracket aim(const Bracket& b, int pass)
{
    constexpr int kAims = 6;
    if (b.count <= kTreeWidth)
        return b;
    const float count = static_cast<float>(b.count), rank = static_cast<float>(b.k) - 0.5f;
    const float spread = 1.0f + 1.5f * std::sqrt(rank * (1.0f - rank / count));
    const float step = (b.high - b.low) / count;
    const float low = std::max(b.low, b.low + step * (rank - spread));
    const float high = std::min(b.high, b.low + step * (rank + spread));
    if (pass < kAims && low < high)
        return {low, high, 0, 0};
    const std::uint32_t middle = bits(b.low) + (bits(b.high) - bits(b.low)) / 2;
    return {b.low, std::bit_cast<float>(middle), 0, 0};
}

/// What narrow found.
struct Counts {
    std::size_t below, within;
};

/// Copies the values in [to.low, to.high) to `out`, which may be `in`, and infinities behind them;
/// counts those, and those in [from, to.low).
HWY_INLINE Counts narrow(std::span<const float> in, float from, const Bracket& to, float* out)
{
    const Floats d;
    const FloatVec first = hn::Set(d, from), low = hn::Set(d, to.low), high = hn::Set(d, to.high);
    Counts counts{0, 0};
    for (std::size_t i = 0; i < in.size(); i += hn::Lanes(d)) {
        const FloatVec value = hn::LoadU(d, in.data() + i);
        const Mask above = hn::Ge(value, low);
        const Mask within = hn::And(above, hn::Lt(value, high));
        counts.below += hn::CountTrue(d, hn::AndNot(above, hn::Ge(value, first)));
        counts.within += write_values(value, within, out + counts.within);
    }
    pad(out + counts.within);
    return counts;
}

/// The k-th smallest of 16 values.
HWY_INLINE float kth_of_few(const float* values, std::size_t k)
{
    const Floats d;
    const FloatVec wanted = hn::Set(d, static_cast<float>(k)), one = hn::Set(d, 1.0f);
    FloatVec kth = hn::Set(d, kFar);
    for (std::size_t lane = 0; lane < kTreeWidth; lane += hn::Lanes(d)) {
        const FloatVec value = hn::LoadU(d, values + lane);
        const auto counted = [&](std::size_t i, FloatVec rank) HWY_ATTR {
            return hn::Add(rank, hn::IfThenElseZero(hn::Le(hn::Set(d, values[i]), value), one));
        };
        FloatVec a = hn::Zero(d), b = a, c = a, e = a; // four, so that none waits for the last
        for (std::size_t i = 0; i < kTreeWidth; i += 4) {
            a = counted(i, a);
            b = counted(i + 1, b);
            c = counted(i + 2, c);
            e = counted(i + 3, e);
        }
        const FloatVec rank = hn::Add(hn::Add(a, b), hn::Add(c, e));
        kth = hn::Min(kth, hn::IfThenElse(hn::Ge(rank, wanted), value, hn::Set(d, kFar)));
    }
    return hn::GetLane(hn::MinOfLanes(d, kth));
}

float KthDistance2(std::size_t k, const Bounds2& bounds, std::size_t inside, TreeScratch& scratch)
{
    const std::span<const float> all(scratch.rows.data()->distance2, kTreeWidth * scratch.filled);
    float* const band = scratch.band.data();
    const auto first = [&](std::size_t count) {
        return std::span<const float>(band, (count + kTreeWidth - 1) / kTreeWidth * kTreeWidth);
    };
    const std::size_t below = inside - scratch.in_band;
    std::span<const float> values = all;
    Bracket b{0.0f, std::nextafter(bounds.high2, kFar), inside, k};
    if (k > below && scratch.in_band > 0) {
        b = {bounds.low2, b.high, scratch.in_band, k - below};
        values = first(b.count);
    }
    for (int pass = 0; bits(b.high) - bits(b.low) > 1; ++pass) {
        if (b.count <= kTreeWidth && values.data() == band)
            return kth_of_few(band, b.k);
        const Bracket to = aim(b, pass);
        const Counts counts = narrow(values, b.low, to, band);
        const std::size_t passed = counts.below + counts.within;
        if (b.k <= counts.below) {
            b = {b.low, to.low, counts.below, b.k};
            values = all;
        } else if (b.k <= passed) {
            b = {to.low, to.high, counts.within, b.k - counts.below};
            values = first(b.count);
        } else {
            b = {to.high, b.high, b.count - passed, b.k - passed};
            values = all;
        }
    }
    return b.low;
}

float GreatestDistance2(float radius2, const TreeScratch& scratch)
{
    const Floats d;
    FloatVec greatest = hn::Zero(d);
    for (std::size_t b = 0; b < scratch.filled; ++b)
        for (std::size_t lane = 0; lane < kTreeWidth; lane += hn::Lanes(d)) {
            const FloatVec value = hn::Load(d, scratch.rows[b].distance2 + lane);
            const Mask inside = hn::Le(value, hn::Set(d, radius2));
            greatest = hn::Max(greatest, hn::IfThenElseZero(inside, value));
        }
    return hn::GetLane(hn::MaxOfLanes(d, greatest));
}

Emitted EmitNearest(float farthest2, TreeScratch& scratch)
{
    const Floats d;
    const FloatVec farthest = hn::Set(d, farthest2);
    grow(scratch.found, kTreeWidth * (scratch.filled + 1));
    grow(scratch.ties, kTreeWidth * (scratch.filled + 1));
    std::uint32_t *const found = scratch.found.data(), *const ties = scratch.ties.data();
    const std::uint32_t* const blocks = scratch.blocks.data();
    Emitted out{0, 0};
    for (std::size_t b = 0; b < scratch.filled; ++b)
        for (std::uint32_t lane = 0; lane < kTreeWidth; lane += hn::Lanes(d)) {
            const FloatVec value = hn::Load(d, scratch.rows[b].distance2 + lane);
            const std::uint32_t first = kTreeWidth * blocks[b] + lane;
            out.nearer += write_lanes(first, hn::Lt(value, farthest), found + out.nearer);
            out.as_far += write_lanes(first, hn::Eq(value, farthest), ties + out.as_far);
        }
    return out;
}

} // namespace hipmap::tree_search::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hipmap::tree_search {

HWY_EXPORT(KthDistance2);
HWY_EXPORT(GreatestDistance2);
HWY_EXPORT(EmitNearest);

float kth_distance2(std::size_t k, const Bounds2& bounds, std::size_t inside, TreeScratch& scratch)
{
    return HWY_DYNAMIC_DISPATCH(KthDistance2)(k, bounds, inside, scratch);
}

float greatest_distance2(float radius2, const TreeScratch& scratch)
{
    return HWY_DYNAMIC_DISPATCH(GreatestDistance2)(radius2, scratch);
}

Emitted emit_nearest(float farthest2, TreeScratch& scratch)
{
    return HWY_DYNAMIC_DISPATCH(EmitNearest)(farthest2, scratch);
}

} // namespace hipmap::tree_search
#endif
