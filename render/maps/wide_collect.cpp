#include "render/maps/wide_kernels.h"

// foreach_target compiles what follows it once for each instruction set.
// clang-format off
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/maps/wide_collect.cpp"
#include <hwy/foreach_target.h>
#include "render/maps/wide_blocks-inl.h"
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace hipmap::tree_search::HWY_NAMESPACE {

/// More than the roundings of a few operations take away.
constexpr float kRoundedUp = 1.00001f;

struct Ball {
    PointVec point;
    FloatVec radius2;
};

/// Writes those children of nodes of a level whose boxes touch the ball, in order; returns their
/// number.
HWY_INLINE std::size_t touched(const WideTree& tree, std::uint32_t level,
                               std::span<const std::uint32_t> parents, const Ball& ball,
                               std::vector<std::uint32_t>& children)
{
    grow(children, kTreeWidth * (parents.size() + 1));
    const BoxNode* const nodes = tree.nodes.data() + tree.first_node[level];
    std::size_t written = 0;
    for (const std::uint32_t node : parents)
        for (std::uint32_t lane = 0; lane < kTreeWidth; lane += hn::Lanes(Floats())) {
            const FloatVec nearest = box_distances2(nodes[node], lane, ball.point).nearest;
            written += write_lanes(kTreeWidth * node + lane, hn::Le(nearest, ball.radius2),
                                   children.data() + written);
        }
    return written;
}

/// Finds the leaf nodes below query.from that the ball touches, and keeps them.
void keep_nodes(const WideTree& tree, const TreeQuery& query, float radius, TreeScratch& scratch)
{
    grow(scratch.nodes, kTreeWidth);
    scratch.nodes[0] = static_cast<std::uint32_t>(query.from.number);
    scratch.kept = 1;
    // Squares that are nearly zero have few digits.
    constexpr float kRoundedOff = std::numeric_limits<float>::min();
    const Ball ball{spread(query.point),
                    hn::Set(Floats(), radius * radius * kRoundedUp + kRoundedOff)};
    for (std::uint32_t level = query.from.level; level + 1 < tree.levels; ++level) {
        scratch.nodes.swap(scratch.parents);
        scratch.kept =
            touched(tree, level, {scratch.parents.data(), scratch.kept}, ball, scratch.nodes);
    }
    scratch.kept_tree = tree.number;
    scratch.kept_from = query.from;
    scratch.kept_point = query.point;
    scratch.kept_radius = radius;
}

/// How much farther than a ball to look for leaf nodes, so that they serve some more searches in
/// steps like the last.
float margin(float radius, float step)
{
    constexpr float kSteps = 8.0f, kMost = 0.5f;
    return step < kMost * radius ? std::min(kSteps * step, kMost * radius) : 0.0f;
}

/// Whether the nodes kept will do for this ball.
bool are_kept(const WideTree& tree, const TreeQuery& query, float radius,
              const TreeScratch& scratch)
{
    return scratch.kept_tree == tree.number &&
           (scratch.kept_from.level == 0 || scratch.kept_from == query.from) &&
           glm::distance(query.point, scratch.kept_point) + radius <= scratch.kept_radius;
}

/// Makes sure that the leaf nodes that the ball touches are kept.
void find_nodes(const WideTree& tree, const TreeQuery& query, float radius2, TreeScratch& scratch)
{
    const float radius = std::sqrt(radius2);
    if (are_kept(tree, query, radius, scratch))
        return;
    const float step = glm::distance(query.point, scratch.last_point);
    keep_nodes(tree, query, radius + margin(radius, step), scratch);
}

std::size_t Collect(const WideTree& tree, const TreeQuery& query, const Bounds2& bounds,
                    TreeScratch& scratch)
{
    scratch.filled = 0;
    scratch.in_band = 0;
    if (tree.size == 0)
        return 0;
    find_nodes(tree, query, bounds.high2, scratch);
    const Ball ball{spread(query.point), hn::Set(Floats(), bounds.high2)};
    const std::size_t count =
        touched(tree, tree.levels - 1, {scratch.nodes.data(), scratch.kept}, ball, scratch.blocks);
    return measure(tree, ball.point, bounds, count, scratch);
}

/// Writes the children of the kept nodes that are wholly nearer than bounds.low2 to scratch.whole,
/// the others that touch the ball to scratch.blocks; returns how many the latter are.
HWY_INLINE std::size_t sort_blocks(const WideTree& tree, const PointVec& point,
                                   const Bounds2& bounds, TreeScratch& scratch)
{
    const Floats d;
    const FloatVec low2 = hn::Set(d, bounds.low2), high2 = hn::Set(d, bounds.high2);
    grow(scratch.whole, kTreeWidth * (scratch.kept + 1));
    grow(scratch.blocks, kTreeWidth * (scratch.kept + 1));
    const BoxNode* const nodes = tree.nodes.data() + tree.first_node[tree.levels - 1];
    std::size_t whole = 0, other = 0;
    for (std::size_t i = 0; i < scratch.kept; ++i) {
        const std::uint32_t node = scratch.nodes[i];
        for (std::uint32_t lane = 0; lane < kTreeWidth; lane += hn::Lanes(d)) {
            const BoxDistances2 box = box_distances2(nodes[node], lane, point);
            const Mask nearer = hn::Lt(box.farthest, low2);
            const Mask rest = hn::AndNot(nearer, hn::Le(box.nearest, high2));
            const std::uint32_t first = kTreeWidth * node + lane;
            if (!hn::AllFalse(d, nearer))
                whole += write_lanes(first, nearer, scratch.whole.data() + whole);
            other += write_lanes(first, rest, scratch.blocks.data() + other);
        }
    }
    scratch.wholes = whole;
    return other;
}

std::size_t CollectShell(const WideTree& tree, const TreeQuery& query, const Bounds2& bounds,
                         TreeScratch& scratch)
{
    scratch.filled = scratch.in_band = scratch.wholes = scratch.in_wholes = 0;
    if (tree.size == 0)
        return 0;
    find_nodes(tree, query, bounds.high2, scratch);
    const PointVec point = spread(query.point);
    const std::size_t count = sort_blocks(tree, point, bounds, scratch);
    scratch.in_wholes = photons_in(tree, {scratch.whole.data(), scratch.wholes});
    return scratch.in_wholes + measure(tree, point, bounds, count, scratch);
}

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

HWY_EXPORT(Collect);
HWY_EXPORT(CollectShell);
HWY_EXPORT(CollectNear);
HWY_EXPORT(Descend);

std::size_t collect(const WideTree& tree, const TreeQuery& query, const Bounds2& bounds,
                    TreeScratch& scratch)
{
    return HWY_DYNAMIC_DISPATCH(Collect)(tree, query, bounds, scratch);
}

std::size_t collect_shell(const WideTree& tree, const TreeQuery& query, const Bounds2& bounds,
                          TreeScratch& scratch)
{
    return HWY_DYNAMIC_DISPATCH(CollectShell)(tree, query, bounds, scratch);
}

std::size_t collect_near(const WideTree& tree, const TreeQuery& query, TreeScratch& scratch)
{
    return HWY_DYNAMIC_DISPATCH(CollectNear)(tree, query, scratch);
}

} // namespace tree_search

NearPhoton near_photon(const WideTree& tree, const glm::vec3& point)
{
    using namespace tree_search;
    return HWY_DYNAMIC_DISPATCH(Descend)(tree, point);
}

} // namespace hipmap
#endif
