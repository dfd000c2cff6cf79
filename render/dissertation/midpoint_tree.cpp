#include "render/dissertation/midpoint_tree.h"

#include <algorithm>

namespace hipmap {

namespace {

struct Split {
    int axis;
    float middle; ///< of the cell; all points on one side of it only if they coincide
};

Split split_of(std::span<const TreePoint> points)
{
    Bounds<glm::vec3> box;
    for (const TreePoint& point : points)
        box.add(point.position);
    const glm::vec3 extent = box.high - box.low;
    int axis = extent.y >= extent.z ? 1 : 2;
    if (extent.x >= extent.y && extent.x >= extent.z)
        axis = 0;
    const float middle = box.low[axis] + 0.5f * extent[axis];
    // Rounding may leave the middle at the lower end.
    return {axis, middle > box.low[axis] ? middle : box.high[axis]};
}

/// Moves the first point beyond the middle to the front, and those before it ahead of the others.
/// Returns how many are before it.
std::size_t order(std::span<TreePoint> points, const Split& split)
{
    const auto at = [axis = split.axis](const TreePoint& point) { return point.position[axis]; };
    const auto beyond = std::partition(points.begin(), points.end(), [&](const TreePoint& point) {
        return at(point) < split.middle;
    });
    const auto root =
        std::min_element(beyond, points.end(),
                         [&](const TreePoint& a, const TreePoint& b) { return at(a) < at(b); });
    // The root goes to where the others begin; then it changes places with the first of all.
    const auto before = beyond - points.begin();
    std::iter_swap(beyond, root);
    std::iter_swap(points.begin(), beyond);
    return static_cast<std::size_t>(before);
}

void chain(std::span<InsertionNode> nodes, std::uint32_t first)
{
    for (std::uint32_t i = 0; i + 1 < nodes.size(); ++i)
        nodes[i].same = first + i + 1;
}

/// Builds the subtree of a range of slots that begins at `first`.
void build(std::span<TreePoint> points, std::span<InsertionNode> nodes, std::uint32_t first)
{
    const Split split = split_of(points);
    const bool coincide = std::all_of(points.begin(), points.end(), [&](const TreePoint& point) {
        return point.position == points.front().position;
    });
    if (coincide) {
        for (std::size_t i = 0; i < points.size(); ++i)
            nodes[i] = {points[i].position, points[i].photon};
        chain(nodes, first);
        return;
    }
    const std::size_t before = order(points, split);
    nodes[0] = {points[0].position, points[0].photon};
    nodes[0].axis = static_cast<std::uint32_t>(split.axis);
    const std::size_t starts[] = {1, 1 + before}, ends[] = {1 + before, points.size()};
    for (const std::size_t side : {0, 1}) {
        const std::size_t count = ends[side] - starts[side];
        if (count == 0)
            continue;
        const std::uint32_t child = first + static_cast<std::uint32_t>(starts[side]);
        nodes[0].child[side] = child;
        build(points.subspan(starts[side], count), nodes.subspan(starts[side], count), child);
    }
}

} // namespace

InsertionTree build_midpoint_tree(std::span<TreePoint> points)
{
    InsertionTree tree;
    tree.nodes.resize(points.size());
    if (!points.empty())
        build(points, tree.nodes, 0);
    return tree;
}

} // namespace hipmap
