#include "preprocess/partition/face_tree.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <numeric>
#include <tuple>

namespace hipmap {
namespace {

int longest_axis(const glm::vec3& extent)
{
    if (extent.x >= extent.y && extent.x >= extent.z)
        return 0;
    return extent.y >= extent.z ? 1 : 2;
}

} // namespace

FaceTree::FaceTree(const TriangleMesh& mesh, std::span<const std::uint32_t> group_of_face,
                   std::uint32_t group_count)
    : roots_(group_count, Range{0, 0, 0})
{
    // A counting sort by group.
    std::vector<std::uint32_t> next(group_count + std::size_t{1}, 0);
    for (const std::uint32_t group : group_of_face)
        if (group != kNone)
            ++next[group + std::size_t{1}];
    std::partial_sum(next.begin(), next.end(), next.begin());
    std::vector<Item> items(next.back());
    for (std::uint32_t group = 0; group < group_count; ++group)
        roots_[group] = {0, next[group], next[group + std::size_t{1}]};
    for (FaceId face = 0; face < mesh.face_count(); ++face)
        if (group_of_face[face] != kNone)
            items[next[group_of_face[face]]++].face = face;
    tbb::parallel_for(std::size_t{0}, items.size(), [&](std::size_t i) {
        const Bounds<glm::vec3> box = face_box(mesh, items[i].face);
        items[i].middle = 0.5f * box.low + 0.5f * box.high;
    });

    nodes_.reserve(items.size());
    for (Range& root : roots_)
        if (root.begin < root.end)
            root.node = build(mesh, items, root.begin, root.end);
    nodes_.shrink_to_fit();
    faces_.reserve(items.size());
    for (const Item& item : items)
        faces_.push_back(item.face);
}

std::uint32_t FaceTree::build(const TriangleMesh& mesh, std::vector<Item>& items,
                              std::uint32_t begin, std::uint32_t end)
{
    const auto node = static_cast<std::uint32_t>(nodes_.size());
    nodes_.emplace_back();
    Bounds<glm::vec3> box;
    if (Range{node, begin, end}.leaf()) {
        for (std::uint32_t i = begin; i < end; ++i)
            for (int c = 0; c < 3; ++c)
                box.add(mesh.positions[mesh.corners[items[i].face][c]]);
    } else {
        Bounds<glm::vec3> middles;
        for (std::uint32_t i = begin; i < end; ++i)
            middles.add(items[i].middle);
        const int axis = longest_axis(middles.extent());
        const std::uint32_t middle = begin + (end - begin) / 2;
        std::nth_element(items.begin() + begin, items.begin() + middle, items.begin() + end,
                         [axis](const Item& a, const Item& b) {
                             return std::tie(a.middle[axis], a.face) <
                                    std::tie(b.middle[axis], b.face);
                         });
        const std::uint32_t left = build(mesh, items, begin, middle);
        const std::uint32_t right = build(mesh, items, middle, end);
        nodes_[node].right = right;
        for (const std::uint32_t child : {left, right}) {
            box.add(nodes_[child].box.low);
            box.add(nodes_[child].box.high);
        }
    }
    nodes_[node].box = box;
    return node;
}

std::array<FaceTree::Range, 2> FaceTree::children(const Range& range) const
{
    const std::uint32_t middle = range.begin + (range.end - range.begin) / 2;
    return {Range{range.node + 1, range.begin, middle},
            Range{nodes_[range.node].right, middle, range.end}};
}

} // namespace hipmap
