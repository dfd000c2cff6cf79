#include "render/dissertation/insertion_tree.h"

#include <algorithm>

namespace hipmap {

namespace {

std::uint32_t evenest_axis(const Bounds<glm::vec3>& cell, const glm::vec3& point)
{
    const glm::vec3 shorter = glm::min(point - cell.low, cell.high - point);
    if (shorter.x >= shorter.y && shorter.x >= shorter.z)
        return 0;
    return shorter.y >= shorter.z ? 1 : 2;
}

} // namespace

void insert(InsertionTree& tree, const TreePoint& point)
{
    const auto added = static_cast<std::uint32_t>(tree.nodes.size());
    InsertionNode& node = tree.nodes.emplace_back(InsertionNode{point.position, point.photon});
    Bounds<glm::vec3> cell = tree.box;
    for (std::uint32_t at = 0; at != added;) {
        InsertionNode& parent = tree.nodes[at];
        if (parent.position == point.position) {
            node.same = parent.same;
            parent.same = added;
            return;
        }
        const auto axis = static_cast<int>(parent.axis);
        const bool above = point.position[axis] >= parent.position[axis];
        (above ? cell.low : cell.high)[axis] = parent.position[axis];
        std::uint32_t& child = parent.child[above ? 1 : 0];
        if (child == kNoNode)
            child = added;
        at = child;
    }
    node.axis = evenest_axis(cell, point.position);
}

InsertionTree build_insertion_tree(std::span<const TreePoint> points)
{
    InsertionTree tree;
    tree.nodes.reserve(points.size());
    for (const TreePoint& point : points)
        tree.box.add(point.position);
    for (const TreePoint& point : points)
        insert(tree, point);
    return tree;
}

} // namespace hipmap
