#include "render/maps/wide_kernels.h"

#include <string_view>

// foreach_target compiles what follows it once for each instruction set.
// clang-format off
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/maps/wide_ball.cpp"
#include <hwy/foreach_target.h>
#include "render/maps/wide_simd-inl.h"
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace hipmap::tree_search::HWY_NAMESPACE {

/// More than the roundings of a few operations take away.
constexpr float kRoundedUp = 1.00001f;

// No fused multiply-add anywhere, and sums in one order: distances are those of glm::dot, to the
// bit, on every processor.

struct PointVec {
    FloatVec x, y, z;
};

HWY_INLINE PointVec spread(const glm::vec3& point)
{
    const Floats d;
    return {hn::Set(d, point.x), hn::Set(d, point.y), hn::Set(d, point.z)};
}

HWY_INLINE FloatVec length2(FloatVec x, FloatVec y, FloatVec z)
{
    return hn::Add(hn::Add(hn::Mul(x, x), hn::Mul(y, y)), hn::Mul(z, z));
}

HWY_INLINE FloatVec photon_distance2(const PhotonBlock& block, std::size_t lane,
                                     const PointVec& point)
{
    const Floats d;
    return length2(hn::Sub(hn::Load(d, block.position[0] + lane), point.x),
                   hn::Sub(hn::Load(d, block.position[1] + lane), point.y),
                   hn::Sub(hn::Load(d, block.position[2] + lane), point.z));
}

/// Rounding is monotonic, so no photon of the box is nearer than this.
HWY_INLINE FloatVec box_distance2(const BoxNode& node, std::size_t lane, const PointVec& point)
{
    const Floats d;
    const auto outside = [&](int axis, FloatVec p) HWY_ATTR {
        const FloatVec below = hn::Sub(hn::Load(d, node.low[axis] + lane), p);
        const FloatVec above = hn::Sub(p, hn::Load(d, node.high[axis] + lane));
        return hn::Max(hn::Max(below, above), hn::Zero(d));
    };
    return length2(outside(0, point.x), outside(1, point.y), outside(2, point.z));
}

/// Of the farthest corner of the box.
HWY_INLINE FloatVec corner_distance2(const BoxNode& node, std::size_t lane, const PointVec& point)
{
    const Floats d;
    const auto farthest = [&](int axis, FloatVec p) HWY_ATTR {
        return hn::Max(hn::Sub(p, hn::Load(d, node.low[axis] + lane)),
                       hn::Sub(hn::Load(d, node.high[axis] + lane), p));
    };
    return length2(farthest(0, point.x), farthest(1, point.y), farthest(2, point.z));
}

/// Writes those children of `count` nodes of a level whose boxes touch the ball, in order; returns
/// their number.
HWY_INLINE std::size_t touched(const WideTree& tree, std::uint32_t level,
                               const std::vector<std::uint32_t>& parents, std::size_t count,
                               const PointVec& point, FloatVec radius2,
                               std::vector<std::uint32_t>& children)
{
    grow(children, kTreeWidth * (count + 1));
    const BoxNode* const nodes = tree.nodes.data() + tree.first_node[level];
    std::size_t written = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t node = parents[i];
        for (std::uint32_t lane = 0; lane < kTreeWidth; lane += hn::Lanes(Floats())) {
            const FloatVec distance2 = box_distance2(nodes[node], lane, point);
            written += write_lanes(kTreeWidth * node + lane, hn::Le(distance2, radius2),
                                   children.data() + written);
        }
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
    const FloatVec radius2 = hn::Set(Floats(), radius * radius * kRoundedUp + kRoundedOff);
    for (std::uint32_t level = query.from.level; level + 1 < tree.levels; ++level) {
        scratch.nodes.swap(scratch.parents);
        scratch.kept = touched(tree, level, scratch.parents, scratch.kept, spread(query.point),
                               radius2, scratch.nodes);
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

/// Writes the distances of the photons of the first `count` blocks into rows, and those between the
/// bounds once more into the band; returns how many are in the ball.
std::size_t measure(const WideTree& tree, const PointVec& point, const Bounds2& bounds,
                    std::size_t count, TreeScratch& scratch)
{
    const Floats d;
    const FloatVec low2 = hn::Set(d, bounds.low2), high2 = hn::Set(d, bounds.high2);
    grow(scratch.rows, count + 1);
    grow(scratch.band, kTreeWidth * (count + 2));
    float* const band = scratch.band.data();
    const std::uint32_t* const blocks = scratch.blocks.data();
    TreeScratch::Row* const rows = scratch.rows.data();
    std::size_t inside = 0, in_band = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const PhotonBlock& block = tree.blocks[blocks[i]];
        for (std::size_t lane = 0; lane < kTreeWidth; lane += hn::Lanes(d)) {
            const FloatVec distance2 = photon_distance2(block, lane, point);
            const Mask near = hn::Le(distance2, high2);
            hn::Store(distance2, d, rows[i].distance2 + lane);
            inside += hn::CountTrue(d, near);
            in_band +=
                write_values(distance2, hn::And(near, hn::Ge(distance2, low2)), band + in_band);
        }
    }
    pad(band + in_band);
    scratch.filled = count;
    scratch.in_band = in_band;
    return inside;
}

/// Whether the nodes kept will do for this ball.
bool are_kept(const WideTree& tree, const TreeQuery& query, float radius,
              const TreeScratch& scratch)
{
    return scratch.kept_tree == tree.number &&
           (scratch.kept_from.level == 0 || scratch.kept_from == query.from) &&
           glm::distance(query.point, scratch.kept_point) + radius <= scratch.kept_radius;
}

std::size_t Collect(const WideTree& tree, const TreeQuery& query, const Bounds2& bounds,
                    TreeScratch& scratch)
{
    scratch.filled = 0;
    scratch.in_band = 0;
    if (tree.size == 0)
        return 0;
    const float radius = std::sqrt(bounds.high2);
    if (!are_kept(tree, query, radius, scratch)) {
        const float step = glm::distance(query.point, scratch.last_point);
        keep_nodes(tree, query, radius + margin(radius, step), scratch);
    }
    const PointVec point = spread(query.point);
    const std::size_t count = touched(tree, tree.levels - 1, scratch.nodes, scratch.kept, point,
                                      hn::Set(Floats(), bounds.high2), scratch.blocks);
    return measure(tree, point, bounds, count, scratch);
}

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
        hn::Store(box_distance2(boxes, lane, point), d, distance2 + lane);
        hn::Store(corner_distance2(boxes, lane, point), d, corner2 + lane);
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
    return measure(tree, point, {0.0f, std::numeric_limits<float>::max()}, count, scratch);
}

} // namespace hipmap::tree_search::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hipmap {

namespace tree_search {

HWY_EXPORT(Collect);
HWY_EXPORT(CollectNear);

std::size_t collect(const WideTree& tree, const TreeQuery& query, const Bounds2& bounds,
                    TreeScratch& scratch)
{
    return HWY_DYNAMIC_DISPATCH(Collect)(tree, query, bounds, scratch);
}

std::size_t collect_near(const WideTree& tree, const TreeQuery& query, TreeScratch& scratch)
{
    return HWY_DYNAMIC_DISPATCH(CollectNear)(tree, query, scratch);
}

} // namespace tree_search

std::vector<const char*> simd_targets()
{
    hwy::SetSupportedTargetsForTest(0);
    std::vector<const char*> names;
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets())
        names.push_back(hwy::TargetName(target));
    return names;
}

bool use_simd_target(const char* name)
{
    hwy::SetSupportedTargetsForTest(0);
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets())
        if (std::string_view(name) == hwy::TargetName(target)) {
            hwy::GetChosenTarget().Update(target);
            return true;
        }
    return false;
}

} // namespace hipmap
#endif
