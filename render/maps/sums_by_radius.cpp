#include "render/maps/fixed_radius.h"
#include "render/maps/gather.h"

// foreach_target compiles what follows it once for each instruction set.
// clang-format off
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/maps/sums_by_radius.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace hipmap::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Adds powers to the sums of the radii whose squares are not below their square distance.  A sum
/// is by one lane, in the order of the photons, and powers out of reach add zero: the same bits
/// everywhere.
void AddByRadius(std::span<const float> distance2, const PowerBatch& powers,
                 const std::array<float, 3>& radii2, SumsByRadius& sums)
{
    const hn::CappedTag<double, 4> d;
    const std::size_t lanes = hn::Lanes(d);
    const auto first2 = hn::Set(d, double{radii2[0]}), second2 = hn::Set(d, double{radii2[1]}),
               third2 = hn::Set(d, double{radii2[2]});
    for (std::size_t lane = 0; lane < 4; lane += lanes) {
        auto first = hn::Load(d, &sums.of[0][lane]), second = hn::Load(d, &sums.of[1][lane]),
             third = hn::Load(d, &sums.of[2][lane]);
        for (std::size_t i = 0; i < distance2.size(); ++i) {
            const auto far2 = hn::Set(d, double{distance2[i]});
            const auto power = hn::Load(d, &powers.of[i][lane]);
            first = hn::Add(first, hn::IfThenElseZero(hn::Le(far2, first2), power));
            second = hn::Add(second, hn::IfThenElseZero(hn::Le(far2, second2), power));
            third = hn::Add(third, hn::IfThenElseZero(hn::Le(far2, third2), power));
        }
        hn::Store(first, d, &sums.of[0][lane]);
        hn::Store(second, d, &sums.of[1][lane]);
        hn::Store(third, d, &sums.of[2][lane]);
    }
}

} // namespace hipmap::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hipmap {

HWY_EXPORT(AddByRadius);

void add_photons(const PhotonMap& map, std::span<const std::uint32_t> slots,
                 const RadiusQuery& wanted, bool tilted, SumsByRadius& sums)
{
    PowerBatch powers;
    gather_powers(map, slots, wanted.query, powers);
    std::array<float, kBatch> distance2;
    for (std::size_t i = 0; i < slots.size(); ++i) {
        const glm::vec3 way = map.tree.position(slots[i]) - wanted.query.position;
        distance2[i] = glm::dot(way, way);
        if (!tilted)
            continue;
        const double turned = facing({map, slots[i]}, wanted.query, wanted.surfaces);
        for (double& channel : powers.of[i])
            channel *= turned;
    }
    const std::array<float, 3>& radii = wanted.radii;
    HWY_DYNAMIC_DISPATCH(AddByRadius)
    ({distance2.data(), slots.size()}, powers,
     {radii[0] * radii[0], radii[1] * radii[1], radii[2] * radii[2]}, sums);
}

} // namespace hipmap
#endif
