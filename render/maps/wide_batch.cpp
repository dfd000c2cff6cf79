#include "render/maps/wide_batch.h"

#include "render/maps/curve_order.h"
#include "render/maps/wide_kernels.h"

#include <algorithm>
#include <cassert>
#include <limits>

// foreach_target compiles what follows it once for each instruction set.
// clang-format off
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/maps/wide_batch.cpp"
#include <hwy/foreach_target.h>
#include "render/maps/wide_blocks-inl.h"
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace hipmap::tree_search::HWY_NAMESPACE {

using WordVec = hn::Vec<Words>;

/// Vectors of queries for which the tree is walked once.
constexpr std::size_t kTogether = 4;

/// So many blocks can be added to a sum of 32 bits.
constexpr std::size_t kChunk = 4096;

/// A box of points.
struct BoxVec {
    PointVec low, high;
};

/// Queries near each other, one in each lane; unused lanes repeat the first.
struct LaneQueries {
    PointVec point;
    BoxVec box;
    glm::vec3 low, high; ///< the same box
    std::span<const std::uint64_t> order;
};

std::uint32_t number_of(std::uint64_t ordered)
{
    return static_cast<std::uint32_t>(ordered);
}

/// The point of a query, or any one for a query that finds nothing.
glm::vec3 place_of(const glm::vec3& point)
{
    return is_nowhere(point) ? glm::vec3(0) : point;
}

LaneQueries load_queries(std::span<const glm::vec3> points, std::span<const std::uint64_t> order)
{
    const Floats d;
    HWY_ALIGN float at[3][kTreeWidth];
    LaneQueries out;
    out.order = order;
    out.low = out.high = place_of(points[number_of(order[0])]);
    for (std::size_t lane = 0; lane < hn::Lanes(d); ++lane) {
        const glm::vec3 point = place_of(points[number_of(order[lane < order.size() ? lane : 0])]);
        out.low = glm::min(out.low, point);
        out.high = glm::max(out.high, point);
        for (int axis = 0; axis < 3; ++axis)
            at[axis][lane] = point[axis];
    }
    out.point = {hn::Load(d, at[0]), hn::Load(d, at[1]), hn::Load(d, at[2])};
    out.box = {spread(out.low), spread(out.high)};
    return out;
}

/// Children of nodes by the balls of one radius about all points of a box: `inside` of them lie in
/// each ball, and `crossed` others may touch one.
struct SortedChildren {
    std::size_t inside = 0, crossed = 0;
};

/// Nodes of a level, and the radius about each point.
struct Level {
    std::uint32_t level;
    std::span<const std::uint32_t> parents;
    float radius2;
};

/// Writes the children of nodes of a level to scratch.whole if they are in all balls, to `crossed`
/// if they are not and may touch one.
HWY_INLINE SortedChildren sort_children(const WideTree& tree, const Level& of, const BoxVec& points,
                                        std::vector<std::uint32_t>& crossed, TreeScratch& scratch)
{
    const Floats d;
    const FloatVec radius2 = hn::Set(d, of.radius2);
    grow(crossed, kTreeWidth * (of.parents.size() + 1));
    grow(scratch.whole, kTreeWidth * (of.parents.size() + 1));
    const BoxNode* const nodes = tree.nodes.data() + tree.first_node[of.level];
    SortedChildren out;
    for (const std::uint32_t node : of.parents)
        for (std::uint32_t lane = 0; lane < kTreeWidth; lane += hn::Lanes(d)) {
            const BoxDistances2 box = box_distances2(nodes[node], lane, points.low, points.high);
            const Mask inside = hn::Le(box.farthest, radius2);
            const Mask touched = hn::AndNot(inside, hn::Le(box.nearest, radius2));
            const std::uint32_t first = kTreeWidth * node + lane;
            if (!hn::AllFalse(d, inside))
                out.inside += write_lanes(first, inside, scratch.whole.data() + out.inside);
            out.crossed += write_lanes(first, touched, crossed.data() + out.crossed);
        }
    return out;
}

HWY_INLINE void add(const RadiusSum& more, RadiusSum& sum)
{
    sum.power += more.power;
    sum.photons += more.photons;
}

/// Walks down to the leaf nodes that a ball about one of the points may cross, which are then the
/// first in scratch.parents, and returns their number; adds nodes that are in all balls to `sum`.
std::size_t find_crossed(const PoweredTree& of, const BoxVec& points, float radius2, RadiusSum& sum,
                         TreeScratch& scratch)
{
    const WideTree& tree = of.tree;
    grow(scratch.parents, kTreeWidth);
    scratch.parents[0] = 0;
    std::size_t parents = 1;
    for (std::uint32_t level = 0; level + 1 < tree.levels; ++level) {
        const SortedChildren found =
            sort_children(tree, {level, {scratch.parents.data(), parents}, radius2}, points,
                          scratch.nodes, scratch);
        for (std::size_t i = 0; i < found.inside; ++i) {
            const std::uint32_t node = scratch.whole[i];
            add({of.powers.nodes[tree.first_node[level + 1] + node],
                 photons_below(tree, {level + 1, node})},
                sum);
        }
        scratch.parents.swap(scratch.nodes);
        parents = found.crossed;
    }
    return parents;
}

/// The powers of the photons of a block, each in a word that can be read into all lanes.
struct alignas(64) PowerWords {
    std::uint32_t power[3][kTreeWidth];
};

HWY_INLINE void widen(const PowerBlock& block, PowerWords& out)
{
    const Words d;
    const hn::Rebind<std::uint16_t, Words> halves;
    for (int channel = 0; channel < 3; ++channel)
        for (std::size_t lane = 0; lane < kTreeWidth; lane += hn::Lanes(d))
            hn::Store(hn::PromoteTo(d, hn::Load(halves, block.power[channel] + lane)), d,
                      out.power[channel] + lane);
}

/// Sums of the queries of a vector.
struct QuerySums {
    WordVec photons, red, green, blue;
};

HWY_INLINE void add_photon(Mask within, const PowerWords& powers, std::size_t photon,
                           QuerySums& sums)
{
    const Words d;
    const WordVec all = hn::BitCast(d, hn::VecFromMask(Floats(), within));
    const auto kept = [&](int channel) HWY_ATTR {
        return hn::And(all, hn::Set(d, powers.power[channel][photon]));
    };
    sums.photons = hn::Sub(sums.photons, all); // all bits of a lane are -1
    sums.red = hn::Add(sums.red, kept(0));
    sums.green = hn::Add(sums.green, kept(1));
    sums.blue = hn::Add(sums.blue, kept(2));
}

HWY_INLINE void add_sums(const QuerySums& sums, std::span<RadiusSum> out)
{
    const Words d;
    HWY_ALIGN std::uint32_t of[4][kTreeWidth];
    hn::Store(sums.photons, d, of[0]);
    hn::Store(sums.red, d, of[1]);
    hn::Store(sums.green, d, of[2]);
    hn::Store(sums.blue, d, of[3]);
    for (std::size_t lane = 0; lane < out.size(); ++lane)
        add({PowerSum(of[1][lane], of[2][lane], of[3][lane]), of[0][lane]}, out[lane]);
}

/// Adds the photons of blocks within each query's radius.
void add_blocks(const PoweredTree& of, std::span<const std::uint32_t> blocks,
                const PointVec& points, float radius2, std::span<RadiusSum> out)
{
    const Floats d;
    const FloatVec most2 = hn::Set(d, radius2);
    const WordVec zero = hn::Zero(Words());
    PowerWords powers;
    for (std::size_t begin = 0; begin < blocks.size(); begin += kChunk) {
        QuerySums sums{zero, zero, zero, zero};
        for (const std::uint32_t number :
             blocks.subspan(begin, HWY_MIN(kChunk, blocks.size() - begin))) {
            const PhotonBlock& block = of.tree.blocks[number];
            widen(of.powers.blocks[number], powers);
            const auto away = [&](int axis, std::size_t photon, FloatVec point) HWY_ATTR {
                return hn::Sub(hn::Set(d, block.position[axis][photon]), point);
            };
            for (std::size_t photon = 0; photon < kTreeWidth; ++photon) {
                const FloatVec far2 = length2(away(0, photon, points.x), away(1, photon, points.y),
                                              away(2, photon, points.z));
                add_photon(hn::Le(far2, most2), powers, photon, sums);
            }
        }
        add_sums(sums, out);
    }
}

/// Returns the square of the diagonal of a block's box, square scene units.
float width2(const WideTree& tree, std::size_t block)
{
    const BoxNode& node = tree.nodes[tree.first_node[tree.levels - 1] + block / kTreeWidth];
    const std::size_t lane = block % kTreeWidth;
    const auto side = [&](int axis) { return node.high[axis][lane] - node.low[axis][lane]; };
    const glm::vec3 diagonal(side(0), side(1), side(2));
    return glm::dot(diagonal, diagonal);
}

/// Returns the median width2 of some blocks.
float median_width2(const WideTree& tree)
{
    constexpr std::size_t kSome = 63;
    std::vector<float> widths;
    for (std::size_t i = 0; i < kSome; ++i)
        widths.push_back(width2(tree, i * tree.blocks.size() / kSome));
    std::ranges::nth_element(widths, widths.begin() + kSome / 2);
    return widths[kSome / 2];
}

/// Returns whether queries lie within some widths of blocks: else each of them crosses too few of
/// the blocks that they cross together.
bool are_near(const LaneQueries& queries, float widths, float block_width2)
{
    const glm::vec3 apart = queries.high - queries.low;
    return glm::dot(apart, apart) <= widths * widths * block_width2;
}

RadiusSum sum_block(const PoweredTree& of, std::uint32_t block)
{
    std::array<std::uint32_t, 3> sum{};
    for (std::size_t channel = 0; channel < 3; ++channel)
        for (const std::uint16_t power : of.powers.blocks[block].power[channel])
            sum[channel] += power;
    return {PowerSum(sum[0], sum[1], sum[2]), photons_in(of.tree, std::array{block})};
}

/// All queries.
struct ManyQueries {
    const PoweredTree& of;
    std::span<const glm::vec3> points;
    float radius2;
    std::span<RadiusSum> out;
};

void answer_alone(const ManyQueries& all, std::span<const std::uint64_t> order,
                  BatchScratch& scratch)
{
    for (const std::uint64_t ordered : order)
        all.out[number_of(ordered)] =
            sum_within(all.of.tree, all.of.powers, all.points[number_of(ordered)],
                       std::array<float, 1>{all.radius2}, scratch.single)[0];
}

/// What the queries of a group have in common.
struct Group {
    RadiusSum nodes;        ///< in all of the balls of the group
    std::size_t leaves = 0; ///< the first in scratch.search.parents, which its queries may cross
};

void answer(const ManyQueries& all, const Group& group, const LaneQueries& queries,
            BatchScratch& batch)
{
    const WideTree& tree = all.of.tree;
    TreeScratch& scratch = batch.search;
    const SortedChildren found =
        sort_children(tree, {tree.levels - 1, {scratch.parents.data(), group.leaves}, all.radius2},
                      queries.box, scratch.blocks, scratch);
    if (found.crossed > 0 && !are_near(queries, 2, width2(tree, scratch.blocks[0])))
        return answer_alone(all, queries.order, batch);
    RadiusSum in_all = group.nodes;
    for (std::size_t i = 0; i < found.inside; ++i)
        add(sum_block(all.of, scratch.whole[i]), in_all);
    std::array<RadiusSum, kTreeWidth> sums;
    sums.fill(in_all);
    const std::span<RadiusSum> wanted(sums.data(), queries.order.size());
    add_blocks(all.of, {scratch.blocks.data(), found.crossed}, queries.point, all.radius2, wanted);
    for (std::size_t i = 0; i < wanted.size(); ++i)
        all.out[number_of(queries.order[i])] = wanted[i];
}

void SumWithinMany(const PoweredTree& of, std::span<const glm::vec3> points, float radius2,
                   std::span<RadiusSum> out, BatchScratch& scratch)
{
    const ManyQueries all{of, points, radius2, out};
    const std::size_t lanes = hn::Lanes(Floats());
    const float block_width2 = median_width2(of.tree);
    std::span<const std::uint64_t> order = scratch.order;
    while (!order.empty()) {
        std::array<LaneQueries, kTogether> queries;
        std::size_t vectors = 0;
        glm::vec3 low(std::numeric_limits<float>::infinity()), high = -low;
        while (vectors < kTogether && !order.empty()) {
            LaneQueries& next = queries[vectors];
            next = load_queries(points, order.first(HWY_MIN(lanes, order.size())));
            order = order.subspan(next.order.size());
            if (!are_near(next, 4, block_width2)) {
                answer_alone(all, next.order, scratch);
                continue;
            }
            low = glm::min(low, next.low);
            high = glm::max(high, next.high);
            ++vectors;
        }
        if (vectors == 0)
            continue;
        Group group;
        group.leaves =
            find_crossed(of, {spread(low), spread(high)}, radius2, group.nodes, scratch.search);
        for (std::size_t i = 0; i < vectors; ++i)
            answer(all, group, queries[i], scratch);
    }
}

} // namespace hipmap::tree_search::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hipmap {

namespace tree_search {

HWY_EXPORT(SumWithinMany);

} // namespace tree_search

void sum_within(const PoweredTree& of, std::span<const glm::vec3> points, float radius2,
                std::span<RadiusSum> out, BatchScratch& scratch)
{
    assert(points.size() == out.size());
    if (of.tree.size == 0) {
        std::ranges::fill(out, RadiusSum{});
        return;
    }
    order_along_curve({of.tree.low, of.tree.high}, points, scratch.order, scratch.other);
    using namespace tree_search;
    HWY_DYNAMIC_DISPATCH(SumWithinMany)(of, points, radius2, out, scratch);
    for (std::size_t i = 0; i < points.size(); ++i)
        if (is_nowhere(points[i]))
            out[i] = {};
}

} // namespace hipmap
#endif
