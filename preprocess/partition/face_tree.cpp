#include "preprocess/partition/face_tree.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <tuple>

namespace hipmap {
namespace {

struct OrderedFace {
    std::uint64_t code;
    std::uint32_t group;
    FaceId face;

    bool operator<(const OrderedFace& other) const
    {
        return std::tie(group, code, face) < std::tie(other.group, other.code, other.face);
    }
};

/// Puts two zero bits after each of the lowest 21 bits.
std::uint64_t spread_bits(std::uint64_t x)
{
    x = (x | x << 32) & 0x001f00000000ffff;
    x = (x | x << 16) & 0x001f0000ff0000ff;
    x = (x | x << 8) & 0x100f00f00f00f00f;
    x = (x | x << 4) & 0x10c30c30c30c30c3;
    return (x | x << 2) & 0x1249249249249249;
}

/// Place of a point along the curve through a box.
std::uint64_t morton_code(const glm::dvec3& point, const Bounds<glm::vec3>& box)
{
    std::uint64_t code = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const double low = box.low[axis];
        const double size = double{box.high[axis]} - low;
        const double t = size > 0 ? std::clamp((point[axis] - low) / size, 0.0, 1.0) : 0.0;
        code |= spread_bits(static_cast<std::uint64_t>(t * 0x1fffff)) << axis;
    }
    return code;
}

} // namespace

FaceTree::FaceTree(const TriangleMesh& mesh, std::span<const std::uint32_t> group_of_face,
                   std::uint32_t group_count)
    : roots_(group_count, Range{0, 0, 0})
{
    Bounds<glm::vec3> whole;
    for (const glm::vec3& position : mesh.positions)
        whole.add(position);
    std::vector<OrderedFace> order(mesh.face_count());
    tbb::parallel_for(std::size_t{0}, order.size(), [&](std::size_t i) {
        const auto face = static_cast<FaceId>(i);
        const Bounds<glm::vec3> box = face_box(mesh, face);
        const glm::dvec3 middle = 0.5 * (glm::dvec3(box.low) + glm::dvec3(box.high));
        order[i] = {morton_code(middle, whole), group_of_face[face], face};
    });
    tbb::parallel_sort(order);
    while (!order.empty() && order.back().group == kNone)
        order.pop_back();

    faces_.reserve(order.size());
    for (const OrderedFace& face : order)
        faces_.push_back(face.face);
    for (std::size_t begin = 0; begin < order.size();) {
        std::size_t end = begin;
        while (end < order.size() && order[end].group == order[begin].group)
            ++end;
        Range& root = roots_[order[begin].group];
        root = {0, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
        root.node = build(mesh, root.begin, root.end);
        begin = end;
    }
    nodes_.shrink_to_fit();
}

std::uint32_t FaceTree::build(const TriangleMesh& mesh, std::uint32_t begin, std::uint32_t end)
{
    const auto node = static_cast<std::uint32_t>(nodes_.size());
    nodes_.emplace_back();
    const Range range{node, begin, end};
    Bounds<glm::vec3> box;
    if (range.leaf()) {
        for (const FaceId face : faces(range))
            for (int c = 0; c < 3; ++c)
                box.add(mesh.positions[mesh.corners[face][c]]);
    } else {
        const std::uint32_t middle = begin + (end - begin) / 2;
        const std::uint32_t left = build(mesh, begin, middle);
        const std::uint32_t right = build(mesh, middle, end);
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
