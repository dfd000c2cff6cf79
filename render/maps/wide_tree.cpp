#include "render/maps/wide_tree.h"

#include "common/math/bounds.h"
#include "common/math/split_at_rank.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <cassert>
#include <cstring>
#include <limits>

namespace hipmap {

namespace {

using Box = Bounds<glm::vec3>;

/// Below this a range is ordered by one thread.
constexpr std::size_t kParallelSize = 1 << 14;

/// Returns the widest axis of the box of some 256 of the points.
int widest_axis(std::span<const TreePoint> points)
{
    Box box;
    for (std::size_t i = 0; i < points.size(); i += points.size() / 256 + 1)
        box.add(points[i].position);
    const glm::vec3 extent = box.extent();
    if (extent.x >= extent.y && extent.x >= extent.z)
        return 0;
    return extent.y >= extent.z ? 1 : 2;
}

/// Along an axis; then along the others, so that photons of a wall across the axis are not split at
/// random; then by number.
template <int axis>
struct AlongAxis {
    bool operator()(const TreePoint& a, const TreePoint& b) const
    {
        bool less = a.position[axis] < b.position[axis];
        if (a.position[axis] == b.position[axis]) [[unlikely]]
            less = breaks_tie(a, b);
        return less;
    }
    bool breaks_tie(const TreePoint& a, const TreePoint& b) const
    {
        for (const int other : {(axis + 1) % 3, (axis + 2) % 3})
            if (a.position[other] != b.position[other])
                return a.position[other] < b.position[other];
        return a.photon < b.photon;
    }
};

/// In one piece each way: compilers move the members one by one.
void swap_whole(TreePoint& a, TreePoint& b)
{
    std::array<std::byte, sizeof(TreePoint)> whole;
    std::memcpy(&whole, &a, sizeof(TreePoint));
    std::memcpy(static_cast<void*>(&a), &b, sizeof(TreePoint));
    std::memcpy(static_cast<void*>(&b), &whole, sizeof(TreePoint));
}

/// Moves what is less than the pivot to the front and returns how much that is.  Without a branch
/// on the outcome, which no processor could foresee.
template <typename Less>
std::size_t partition(std::span<TreePoint> points, const TreePoint& pivot, const Less& less)
{
    std::size_t front = 0;
    for (TreePoint& point : points) {
        const bool low = less(point, pivot);
        swap_whole(point, points[front]);
        front += low ? 1 : 0;
    }
    return front;
}

/// At most so many are ordered by comparing each with each.
constexpr std::size_t kFew = 32;

/// Sorts at most kFew points along an axis; those nearly as far from the lowest, by their places.
/// Without a branch on the outcome either.
template <int axis>
void sort_few(std::span<TreePoint> points)
{
    constexpr std::int32_t kPlace = kFew - 1; // bits of a key that tell equal ones apart
    float low = points[0].position[axis];
    for (const TreePoint& point : points)
        low = std::min(low, point.position[axis]);
    std::array<std::int32_t, kFew> keys, ranks{};
    keys.fill(std::numeric_limits<std::int32_t>::max());
    std::array<TreePoint, kFew> copy;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto bits = std::bit_cast<std::int32_t>(points[i].position[axis] - low);
        keys[i] = (bits & ~kPlace) | static_cast<std::int32_t>(i);
        copy[i] = points[i];
    }
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t j = 0; j < kFew; ++j)
            ranks[j] += keys[i] < keys[j] ? 1 : 0;
    for (std::size_t i = 0; i < points.size(); ++i)
        points[static_cast<std::size_t>(ranks[i])] = copy[i];
}

/// Moves the lowest `count` points to the front, as std::nth_element does.
template <int axis>
void split(std::span<TreePoint> points, std::size_t count)
{
    constexpr int kMostRounds = 32; // pivots of any use need far fewer
    const AlongAxis<axis> less;
    for (int round = 0; points.size() > kFew && round < kMostRounds; ++round) {
        if (count == 0 || count == points.size())
            return;
        const TreePoint pivot = pivot_near(std::span<const TreePoint>(points), count, less);
        const std::size_t lower = partition(points, pivot, less);
        if (count <= lower) {
            points = points.first(lower);
        } else {
            points = points.subspan(lower);
            count -= lower;
        }
    }
    if (points.size() <= kFew)
        sort_few<axis>(points);
    else
        std::nth_element(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(count),
                         points.end(), less);
}

/// Halves a range of children of `child_size` points each (the last may have fewer) until each is
/// one child, then goes on inside.  So every child but the last of a level is full.
void order_blocks(std::span<TreePoint> points, std::size_t child_size)
{
    while (points.size() <= child_size) {
        if (child_size == kTreeWidth)
            return;
        child_size /= kTreeWidth;
    }
    const std::size_t children = (points.size() + child_size - 1) / child_size;
    const std::size_t middle = children / 2 * child_size;
    switch (widest_axis(points)) {
    case 0:
        split<0>(points, middle);
        break;
    case 1:
        split<1>(points, middle);
        break;
    default:
        split<2>(points, middle);
    }
    const auto low = [&] { order_blocks(points.first(middle), child_size); };
    const auto high = [&] { order_blocks(points.subspan(middle), child_size); };
    if (points.size() >= kParallelSize) {
        tbb::parallel_invoke(low, high);
    } else {
        low();
        high();
    }
}

Box fill_block(std::span<const TreePoint> points, PhotonBlock& block)
{
    Box box;
    for (std::size_t lane = 0; lane < kTreeWidth; ++lane) {
        const bool there = lane < points.size();
        if (there)
            box.add(points[lane].position);
        for (int axis = 0; axis < 3; ++axis)
            block.position[axis][lane] =
                there ? points[lane].position[axis] : std::numeric_limits<float>::infinity();
    }
    return box;
}

Box fill_node(std::span<const Box> children, BoxNode& node)
{
    Box box;
    for (std::size_t lane = 0; lane < kTreeWidth; ++lane) {
        const bool there = lane < children.size();
        if (there) {
            box.add(children[lane].low);
            box.add(children[lane].high);
        }
        for (int axis = 0; axis < 3; ++axis) {
            constexpr float kFar = std::numeric_limits<float>::infinity();
            node.low[axis][lane] = there ? children[lane].low[axis] : kFar;
            node.high[axis][lane] = there ? children[lane].high[axis] : -kFar;
        }
    }
    return box;
}

/// out[i] and its box from the i-th 16 of `in`.
template <typename In, typename Out, typename Fill>
std::vector<Box> fill_level(std::span<const In> in, std::span<Out> out, const Fill& fill)
{
    std::vector<Box> boxes(out.size());
    tbb::parallel_for(std::size_t{0}, out.size(), [&](std::size_t i) {
        const std::size_t begin = kTreeWidth * i;
        boxes[i] =
            fill(in.subspan(begin, std::min<std::size_t>(kTreeWidth, in.size() - begin)), out[i]);
    });
    return boxes;
}

/// Finds out how many nodes each level has, and where they begin.
void lay_out_levels(WideTree& tree)
{
    std::array<std::size_t, 7> sizes{}; // leaves first
    std::size_t size = tree.blocks.size();
    do {
        size = (size + kTreeWidth - 1) / kTreeWidth;
        sizes[tree.levels++] = size;
    } while (size > 1);
    std::size_t begin = 0;
    for (std::uint32_t level = 0; level < tree.levels; ++level) {
        tree.first_node[level] = static_cast<std::uint32_t>(begin);
        begin += sizes[tree.levels - 1 - level];
    }
    tree.nodes.resize(begin);
}

/// Returns the number of slots that a full node of the level holds.
std::uint64_t slots_of_node(const WideTree& tree, std::uint32_t level)
{
    return std::uint64_t{1} << 4 * (tree.levels - level + 1);
}

} // namespace

std::uint64_t first_slot(const WideTree& tree, const TreeNode& node)
{
    return node.number * slots_of_node(tree, node.level);
}

std::uint64_t photons_below(const WideTree& tree, const TreeNode& node)
{
    return std::min(slots_of_node(tree, node.level), tree.size - first_slot(tree, node));
}

TreeNode lowest_node(const WideTree& tree, std::uint64_t low, std::uint64_t high)
{
    for (std::uint32_t level = tree.levels; level-- > 0;) {
        const std::uint64_t slots = slots_of_node(tree, level);
        if (low / slots == high / slots)
            return {level, low / slots};
    }
    return {};
}

WideTree build_wide_tree(std::span<TreePoint> points)
{
    assert(points.size() <= std::numeric_limits<std::uint32_t>::max());
    static std::atomic<std::uint64_t> trees{0};
    WideTree tree;
    tree.number = ++trees;
    tree.size = points.size();
    if (points.empty())
        return tree;
    std::size_t child_size = kTreeWidth;
    while (child_size * kTreeWidth < points.size())
        child_size *= kTreeWidth;
    order_blocks(points, child_size);

    tree.blocks.resize((points.size() + kTreeWidth - 1) / kTreeWidth);
    std::vector<Box> boxes = fill_level<TreePoint, PhotonBlock>(points, tree.blocks, fill_block);
    lay_out_levels(tree);
    std::size_t end = tree.nodes.size();
    for (std::uint32_t level = tree.levels; level-- > 0;) {
        const std::size_t begin = tree.first_node[level];
        boxes = fill_level<Box, BoxNode>(boxes, std::span(tree.nodes).subspan(begin, end - begin),
                                         fill_node);
        end = begin;
    }
    tree.low = boxes[0].low;
    tree.high = boxes[0].high;
    return tree;
}

std::vector<TreePoint> every_nth_photon(const WideTree& tree, std::uint32_t n)
{
    std::vector<TreePoint> points;
    for (std::uint64_t i = 0; i * n < tree.size; ++i) {
        const auto slot = static_cast<std::uint32_t>(std::min(i * n + i % n, tree.size - 1));
        points.push_back({tree.position(slot), slot});
    }
    return points;
}

WideTree build_blocks(std::span<const TreePoint> points)
{
    WideTree tree;
    tree.size = points.size();
    tree.blocks.resize((points.size() + kTreeWidth - 1) / kTreeWidth);
    fill_level<TreePoint, PhotonBlock>(points, tree.blocks, fill_block);
    return tree;
}

} // namespace hipmap
