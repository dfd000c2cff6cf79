#include "render/dissertation/balanced_tree.h"

#include "common/math/bounds.h"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <utility>

namespace hipmap {

namespace {

/// Below this a range is ordered by one thread.
constexpr std::size_t kParallelSize = 1 << 14;

int widest_axis(std::span<const TreePoint> points)
{
    Bounds<glm::vec3> box;
    for (const TreePoint& point : points)
        box.add(point.position);
    const glm::vec3 extent = box.extent();
    if (extent.x >= extent.y && extent.x >= extent.z)
        return 0;
    return extent.y >= extent.z ? 1 : 2;
}

void order(std::span<TreePoint> points, std::span<std::uint8_t> axes)
{
    if (points.size() <= kBalancedLeaf)
        return;
    const int axis = widest_axis(points);
    const std::size_t middle = points.size() / 2;
    std::nth_element(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(middle),
                     points.end(), [axis](const TreePoint& a, const TreePoint& b) {
                         const float x = a.position[axis], y = b.position[axis];
                         return x < y || (x == y && a.photon < b.photon);
                     });
    axes[middle] = static_cast<std::uint8_t>(axis);
    const auto low = [&] { order(points.first(middle), axes.first(middle)); };
    const auto high = [&] { order(points.subspan(middle + 1), axes.subspan(middle + 1)); };
    if (points.size() >= kParallelSize) {
        tbb::parallel_invoke(low, high);
    } else {
        low();
        high();
    }
}

} // namespace

BalancedTree build_balanced_tree(std::vector<TreePoint> points)
{
    BalancedTree tree{std::move(points), {}};
    tree.axes.resize(tree.points.size());
    order(tree.points, tree.axes);
    return tree;
}

} // namespace hipmap
