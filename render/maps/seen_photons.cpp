#include "render/maps/seen_photons.h"

// foreach_target compiles what follows it once for each instruction set.
// clang-format off
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/maps/seen_photons.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace hipmap::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Doubles = hn::CappedTag<double, 8>;
using DoubleVec = hn::Vec<Doubles>;

struct Vec3 {
    DoubleVec x, y, z;
};

/// The dot products, added in the order of glm's.
HWY_INLINE DoubleVec along(const Vec3& a, const glm::dvec3& axis)
{
    const Doubles d;
    return hn::Add(hn::Add(hn::Mul(a.x, hn::Set(d, axis.x)), hn::Mul(a.y, hn::Set(d, axis.y))),
                   hn::Mul(a.z, hn::Set(d, axis.z)));
}

/// Whether a wall hides points of the plane, docs/visible_area.md (A1).
HWY_INLINE hn::Mask<Doubles> hidden_by(const DiscWall& wall, DoubleVec x, DoubleVec y)
{
    const Doubles d;
    const auto zero = hn::Zero(d);
    const auto s = hn::Sub(hn::Mul(x, hn::Set(d, wall.b.y)), hn::Mul(y, hn::Set(d, wall.b.x)));
    const auto t = hn::Sub(hn::Mul(hn::Set(d, wall.a.x), y), hn::Mul(hn::Set(d, wall.a.y), x));
    return hn::And(hn::And(hn::Ge(s, zero), hn::Ge(t, zero)),
                   hn::Gt(hn::Add(s, t), hn::Set(d, wall.cross)));
}

/// Which of the photons are seen past the walls, operation by operation as VisibleDisc::sees finds
/// it.
std::uint64_t SeenPast(const DiscView& view, const PhotonPlaces& photons)
{
    const Doubles d;
    const hn::Rebind<float, Doubles> f;
    const std::size_t lanes = hn::Lanes(d);
    const auto slack = hn::Set(d, view.fold.slack), nearest2 = hn::Set(d, view.nearest2);
    const auto off = [&](int axis, std::size_t i) {
        return hn::Sub(hn::PromoteTo(d, hn::Load(f, &photons.of[axis][i])),
                       hn::Set(d, view.centre[axis]));
    };
    std::uint64_t out = 0;
    for (std::size_t i = 0; i < photons.count; i += lanes) {
        const Vec3 way{off(0, i), off(1, i), off(2, i)};
        const auto x = along(way, view.x_axis), y = along(way, view.y_axis);
        const auto above = hn::Sub(hn::Abs(along(way, view.normal)), slack);
        const auto away2 = hn::Add(hn::Mul(x, x), hn::Mul(y, y));
        const auto on_fold =
            hn::Or(hn::Not(hn::Gt(above, hn::Zero(d))), hn::Le(hn::Mul(above, above), away2));
        auto hidden = hn::FirstN(d, 0);
        for (const DiscWall& wall : view.walls)
            hidden = hn::Or(hidden, hidden_by(wall, x, y));
        const auto seen = hn::And(on_fold, hn::Or(hn::Le(away2, nearest2), hn::Not(hidden)));
        std::uint8_t bits[8] = {};
        hn::StoreMaskBits(d, seen, bits);
        out |= std::uint64_t{bits[0]} << i;
    }
    return out;
}

} // namespace hipmap::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hipmap {

HWY_EXPORT(SeenPast);

std::uint64_t seen_photons(const VisibleDisc& disc, const PhotonPlaces& photons)
{
    const std::uint64_t all = photons.count < PhotonPlaces::kMost
                                  ? (std::uint64_t{1} << photons.count) - 1
                                  : ~std::uint64_t{0};
    if (disc.sees_everything())
        return all;
    if (const std::optional<DiscView> view = disc.few_walls())
        return HWY_DYNAMIC_DISPATCH(SeenPast)(*view, photons) & all;
    std::uint64_t out = 0;
    for (std::size_t i = 0; i < photons.count; ++i)
        if (disc.sees({photons.of[0][i], photons.of[1][i], photons.of[2][i]}))
            out |= std::uint64_t{1} << i;
    return out;
}

} // namespace hipmap
#endif
