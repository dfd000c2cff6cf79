#include "render/dissertation/kd_tree.h"

#include "render/dissertation/midpoint_tree.h"

#include <cassert>

namespace hipmap {

KdTree build_kd_tree(TreeKind kind, std::span<TreePoint> points)
{
    assert(kind != TreeKind::wide);
    KdTree tree;
    if (kind == TreeKind::balanced) {
        tree.balanced = build_balanced_tree({points.begin(), points.end()});
        std::copy(tree.balanced.points.begin(), tree.balanced.points.end(), points.begin());
        for (std::uint32_t slot = 0; slot < points.size(); ++slot)
            tree.balanced.points[slot].photon = slot;
    } else {
        tree.unbalanced =
            kind == TreeKind::midpoint ? build_midpoint_tree(points) : build_insertion_tree(points);
        for (std::uint32_t slot = 0; slot < points.size(); ++slot)
            tree.unbalanced.nodes[slot].photon = slot;
    }
    return tree;
}

} // namespace hipmap
