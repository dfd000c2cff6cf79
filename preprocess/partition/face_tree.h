#pragma once

#include "common/math/bounds.h"
#include "common/scene/mesh.h"

#include <array>
#include <bit>
#include <span>

namespace hipmap {

/// Returns whether two boxes have a point in common.
inline bool meet(const Bounds<glm::vec3>& a, const Bounds<glm::vec3>& b)
{
    // Without branches, which would be guesses.
    return (a.low.x <= b.high.x) & (b.low.x <= a.high.x) & (a.low.y <= b.high.y) &
           (b.low.y <= a.high.y) & (a.low.z <= b.high.z) & (b.low.z <= a.high.z);
}

/// Returns a box with each side moved outwards, scene units.
inline Bounds<glm::vec3> widened(const Bounds<glm::vec3>& box, double by)
{
    return {glm::vec3(glm::dvec3(box.low) - by), glm::vec3(glm::dvec3(box.high) + by)};
}

/// A tree of boxes over faces: a complete binary tree, each node of which holds consecutive faces
/// in the order of the tree.  Read-only once built: any number of threads may walk it.
class FaceTree {
  public:
    struct Range {
        std::uint32_t node, begin, end;
    };

    FaceTree() = default; ///< of no faces

    /// Builds the tree by halving the faces of each node along its longest axis.  The same faces
    /// give the same tree. O(n log n), parallel; 24 bytes a node, at most one node to four faces.
    FaceTree(const TriangleMesh& mesh, std::span<const FaceId> faces);

    /// Updates the boxes to the current positions of the same faces; faces stay in their nodes.  A
    /// visit then meets the same faces as in a new tree, in another order, if only faces whose own
    /// boxes meet the query count.  Linear, parallel.
    void refit(const TriangleMesh& mesh);

    /// Returns the root; without faces it is empty and has no box.
    Range root() const { return {0, 0, static_cast<std::uint32_t>(faces_.size())}; }
    bool is_leaf(const Range& range) const { return range.node >= leaf_count() - 1; }
    /// Returns the two children of a node that is no leaf.
    std::array<Range, 2> children(const Range& range) const
    {
        const auto child_depth = static_cast<std::uint32_t>(std::bit_width(range.node + 1));
        const std::uint64_t right =
            2 * std::uint64_t{range.node} + 2 - ((std::uint64_t{1} << child_depth) - 1);
        const std::uint32_t middle = node_at(child_depth, right).begin;
        return {Range{2 * range.node + 1, range.begin, middle},
                Range{2 * range.node + 2, middle, range.end}};
    }
    const Bounds<glm::vec3>& box(const Range& range) const { return boxes_[range.node]; }
    std::span<const FaceId> faces(const Range& range) const
    {
        return std::span(faces_).subspan(range.begin, range.end - range.begin);
    }

    std::uint32_t leaf_count() const { return std::uint32_t{1} << depth_; }
    /// Returns leaf `index`, below leaf_count().  Neighbouring leaves are near each other.
    Range leaf(std::uint32_t index) const { return node_at(depth_, index); }

    /// Returns, by Range::node, the label that all faces below a node have, or kNone if they
    /// differ. label_of_face: by FaceId.  Linear.
    std::vector<std::uint32_t> labels_of_nodes(std::span<const std::uint32_t> label_of_face) const;

    /// Calls visit(FaceId) for every face whose leaf's box meets `box`, in the order of the tree.
    /// Leaves out nodes for which `skip(Range)` returns true; it may be asked of any node.
    template <typename Skip, typename Visit>
    void visit(const Bounds<glm::vec3>& box, const Skip& skip, const Visit& visit_face) const
    {
        std::array<Range, kMostDepth + 2> stack;
        std::size_t depth = 0;
        const auto push = [&](const Range& range) {
            stack[depth] = range;
            depth += std::size_t{meet(box, this->box(range))} & std::size_t{!skip(range)};
        };
        push(root());
        while (depth > 0) {
            const Range range = stack[--depth];
            if (is_leaf(range)) {
                for (const FaceId face : faces(range))
                    visit_face(face);
                continue;
            }
            const auto [left, right] = children(range);
            push(right);
            push(left);
        }
    }

    /// The greatest depth of a node: halving 2^32 faces goes 32 deep.
    static constexpr std::size_t kMostDepth = 32;

  private:
    struct Item;

    Range node_at(std::uint32_t depth, std::uint64_t index) const
    {
        const std::uint64_t count = faces_.size();
        return {static_cast<std::uint32_t>((std::uint64_t{1} << depth) - 1 + index),
                static_cast<std::uint32_t>(index * count >> depth),
                static_cast<std::uint32_t>((index + 1) * count >> depth)};
    }
    void build(const TriangleMesh& mesh, std::span<Item> items, const Range& range);

    std::vector<FaceId> faces_;
    std::vector<Bounds<glm::vec3>> boxes_ =
        std::vector<Bounds<glm::vec3>>(1); ///< the children of node i are 2 i + 1 and 2 i + 2
    std::uint32_t depth_ = 0;              ///< of the leaves
};

/// Returns the box of one face.
inline Bounds<glm::vec3> face_box(const TriangleMesh& mesh, FaceId face)
{
    Bounds<glm::vec3> box;
    for (int c = 0; c < 3; ++c)
        box.add(mesh.positions[mesh.corners[face][c]]);
    return box;
}

} // namespace hipmap
