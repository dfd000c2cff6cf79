#include "render/maps/wide_descend.h"

// foreach_target compiles what follows it once for each instruction set.
// clang-format off
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/maps/wide_descend.cpp"
#include <hwy/foreach_target.h>
#include "render/maps/wide_blocks-inl.h"
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace hipmap::tree_search::HWY_NAMESPACE {

/// The first of the smallest of 16 values.
struct Least {
    std::uint32_t lane;
    float value;
};

template <typename ValuesAt>
HWY_INLINE Least least_of(const ValuesAt& values_at)
{
    const Floats d;
    Least least{0, std::numeric_limits<float>::infinity()};
    for (std::size_t lane = 0; lane < kTreeWidth; lane += hn::Lanes(d)) {
        const FloatVec values = values_at(lane);
        const FloatVec smallest = hn::MinOfLanes(d, values);
        const float value = hn::GetLane(smallest);
        if (value < least.value)
            least = {static_cast<std::uint32_t>(
                         lane + hn::FindKnownFirstTrue(d, hn::Eq(values, smallest))),
                     value};
    }
    return least;
}

NearPhoton Descend(const WideTree& tree, const glm::vec3& at)
{
    const PointVec point = spread(at);
    std::uint32_t node = 0;
    for (std::uint32_t level = 0; level < tree.levels; ++level) {
        const BoxNode& boxes = tree.nodes[tree.first_node[level] + node];
        const Least least = least_of(
            [&](std::size_t lane) HWY_ATTR { return box_distances2(boxes, lane, point).nearest; });
        node = kTreeWidth * node + least.lane;
    }
    const PhotonBlock& block = tree.blocks[node];
    const Least least =
        least_of([&](std::size_t lane) HWY_ATTR { return photon_distance2(block, lane, point); });
    return {kTreeWidth * node + least.lane, least.value};
}

} // namespace hipmap::tree_search::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hipmap {

namespace tree_search {

HWY_EXPORT(Descend);

} // namespace tree_search

NearPhoton near_photon(const WideTree& tree, const glm::vec3& point)
{
    using namespace tree_search;
    return HWY_DYNAMIC_DISPATCH(Descend)(tree, point);
}

} // namespace hipmap
#endif
