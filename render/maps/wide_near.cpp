#include "render/maps/wide_kernels.h"

// foreach_target compiles what follows it once for each instruction set.
// clang-format off
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/maps/wide_near.cpp"
#include <hwy/foreach_target.h>
#include "render/maps/wide_blocks-inl.h"
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace hipmap::tree_search::HWY_NAMESPACE {

/// A child of a node.
struct Child {
    float distance2, corner2;
    std::size_t number; ///< on its level

    /// Nearer first; of several boxes round a point, the one whose farthest corner is nearest.
    bool operator<(const Child& other) const
    {
        return distance2 < other.distance2 ||
               (distance2 == other.distance2 && corner2 < other.corner2);
    }
};
using Children = std::array<Child, kTreeWidth>;

HWY_INLINE Children children_of(const WideTree& tree, std::uint32_t level, std::size_t node,
                                const PointVec& point)
{
    const Floats d;
    const BoxNode& boxes = tree.nodes[tree.first_node[level] + node];
    HWY_ALIGN float distance2[kTreeWidth], corner2[kTreeWidth];
    for (std::size_t lane = 0; lane < kTreeWidth; lane += hn::Lanes(d)) {
        const BoxDistances2 box = box_distances2(boxes, lane, point);
        hn::Store(box.nearest, d, distance2 + lane);
        hn::Store(box.farthest, d, corner2 + lane);
    }
    Children children;
    for (std::size_t lane = 0; lane < kTreeWidth; ++lane)
        children[lane] = {distance2[lane], corner2[lane], kTreeWidth * node + lane};
    return children;
}

std::size_t CollectNear(const WideTree& tree, const TreeQuery& query, TreeScratch& scratch)
{
    const PointVec point = spread(query.point);
    const std::size_t k = query.photons;
    const std::uint32_t from = query.from.level;
    std::size_t child_blocks = std::size_t{1} << 4 * (tree.levels - from - 1);
    Children children = children_of(tree, from, query.from.number, point);
    for (std::uint32_t level = from + 1; kTreeWidth * child_blocks >= 2 * k && child_blocks > 1;
         ++level) {
        const auto has_too_few = [&](const Child& child) {
            return kTreeWidth * child_blocks * child.number + k > tree.size;
        };
        const auto end = std::remove_if(children.begin(), children.end(), has_too_few);
        children = children_of(tree, level, std::min_element(children.begin(), end)->number, point);
        child_blocks /= kTreeWidth;
    }
    std::sort(children.begin(), children.end());
    grow(scratch.blocks, 2 * k / kTreeWidth + child_blocks + 2);
    std::size_t count = 0;
    for (const Child& child : children) {
        const std::size_t end = std::min(tree.blocks.size(), (child.number + 1) * child_blocks);
        for (std::size_t block = child.number * child_blocks; block < end; ++block)
            scratch.blocks[count++] = static_cast<std::uint32_t>(block);
        if (kTreeWidth * count > 2 * k + kTreeWidth)
            break;
    }
    return measure(tree, point, {0.0f, std::numeric_limits<float>::max(), 0.0f}, count, scratch);
}

} // namespace hipmap::tree_search::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hipmap::tree_search {

HWY_EXPORT(CollectNear);

std::size_t collect_near(const WideTree& tree, const TreeQuery& query, TreeScratch& scratch)
{
    return HWY_DYNAMIC_DISPATCH(CollectNear)(tree, query, scratch);
}

} // namespace hipmap::tree_search
#endif
