#include "preprocess/partition/face_tree.h"

#include "common/math/split_at_rank.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <bit>

namespace hipmap {
namespace {

constexpr std::uint64_t kLeafSize = 16;

/// A node of fewer faces is built by one thread.
constexpr std::uint32_t kTaskSize = 4096;

/// The bits of a number, so that they are ordered as numbers are.
std::uint32_t ordered_bits(float number)
{
    const auto bits = std::bit_cast<std::uint32_t>(number);
    return bits >> 31 ? ~bits : bits | 0x80000000u;
}

float number_of(std::uint32_t ordered)
{
    return std::bit_cast<float>(ordered >> 31 ? ordered & 0x7fffffffu : ~ordered);
}

} // namespace

/// A face by the middle of its box.
struct FaceTree::Item {
    std::array<std::uint32_t, 3> middle{}; ///< as ordered bits
    FaceId face = kNone;

    /// Orders faces along an axis, no two alike, by one comparison.
    std::uint64_t key(std::size_t axis) const { return std::uint64_t{middle[axis]} << 32 | face; }

    static std::size_t longest_axis(std::span<const Item> items);

    /// Moves the `rank` items that come first along an axis to the front.
    template <std::size_t axis>
    static void split(std::span<Item> items, std::size_t rank)
    {
        split_at_rank(items, rank,
                      [](const Item& a, const Item& b) { return a.key(axis) < b.key(axis); });
    }
};

std::size_t FaceTree::Item::longest_axis(std::span<const Item> items)
{
    std::array<std::uint32_t, 3> low = items[0].middle;
    std::array<std::uint32_t, 3> high = low;
    for (const Item& item : items)
        for (std::size_t axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], item.middle[axis]);
            high[axis] = std::max(high[axis], item.middle[axis]);
        }
    std::array<float, 3> extent;
    for (std::size_t axis = 0; axis < 3; ++axis)
        extent[axis] = number_of(high[axis]) - number_of(low[axis]);
    return static_cast<std::size_t>(std::ranges::max_element(extent) - extent.begin());
}

FaceTree::FaceTree(const TriangleMesh& mesh, std::span<const FaceId> faces)
    : faces_(faces.begin(), faces.end())
{
    while (kLeafSize << depth_ < faces.size())
        ++depth_;
    boxes_.resize(2 * std::size_t{leaf_count()} - 1);
    std::vector<Item> items(faces.size());
    tbb::parallel_for(std::size_t{0}, items.size(), [&](std::size_t i) {
        const Bounds<glm::vec3> box = face_box(mesh, faces[i]);
        const glm::vec3 middle = 0.5f * box.low + 0.5f * box.high;
        items[i] = {{ordered_bits(middle.x), ordered_bits(middle.y), ordered_bits(middle.z)},
                    faces[i]};
    });
    build(mesh, items, root());
}

void FaceTree::build(const TriangleMesh& mesh, std::span<Item> items, const Range& range)
{
    Bounds<glm::vec3>& box = boxes_[range.node];
    if (is_leaf(range)) {
        for (std::uint32_t i = range.begin; i < range.end; ++i) {
            faces_[i] = items[i].face;
            const Bounds<glm::vec3> of_face = face_box(mesh, faces_[i]);
            box.add(of_face.low);
            box.add(of_face.high);
        }
        return;
    }
    const std::size_t axis =
        Item::longest_axis(items.subspan(range.begin, range.end - range.begin));
    const auto [left, right] = children(range);
    const auto split = std::array{&Item::split<0>, &Item::split<1>, &Item::split<2>}[axis];
    split(items.subspan(range.begin, range.end - range.begin), right.begin - range.begin);
    const auto build_left = [&, half = left] { build(mesh, items, half); };
    const auto build_right = [&, half = right] { build(mesh, items, half); };
    if (range.end - range.begin < kTaskSize) {
        build_left();
        build_right();
    } else {
        tbb::parallel_invoke(build_left, build_right);
    }
    for (const Range& child : {left, right}) {
        box.add(boxes_[child.node].low);
        box.add(boxes_[child.node].high);
    }
}

void FaceTree::refit(const TriangleMesh& mesh)
{
    tbb::parallel_for(std::uint32_t{0}, leaf_count(), [&](std::uint32_t index) {
        const Range range = leaf(index);
        boxes_[range.node] = {};
        for (const FaceId face : faces(range)) {
            const Bounds<glm::vec3> of_face = face_box(mesh, face);
            boxes_[range.node].add(of_face.low);
            boxes_[range.node].add(of_face.high);
        }
    });
    for (std::size_t node = leaf_count() - 1; node-- > 0;) {
        const Bounds<glm::vec3>&left = boxes_[2 * node + 1], &right = boxes_[2 * node + 2];
        boxes_[node] = {glm::min(left.low, right.low), glm::max(left.high, right.high)};
    }
}

std::vector<std::uint32_t>
FaceTree::labels_of_nodes(std::span<const std::uint32_t> label_of_face) const
{
    std::vector<std::uint32_t> labels(boxes_.size(), kNone);
    tbb::parallel_for(std::uint32_t{0}, leaf_count(), [&](std::uint32_t index) {
        const Range range = leaf(index);
        const std::span<const FaceId> here = faces(range);
        if (!here.empty() && std::ranges::all_of(here, [&](FaceId face) {
                return label_of_face[face] == label_of_face[here[0]];
            }))
            labels[range.node] = label_of_face[here[0]];
    });
    for (std::size_t node = leaf_count() - 1; node-- > 0;)
        if (labels[2 * node + 1] == labels[2 * node + 2])
            labels[node] = labels[2 * node + 1];
    return labels;
}

} // namespace hipmap
