#pragma once

#include "common/math/bounds.h"
#include "common/scene/mesh.h"

#include <array>
#include <span>

namespace hipmap {

/// A tree of boxes over the faces of each group.  Read-only once built: any number of threads may
/// walk it.
class FaceTree {
  public:
    /// A node: some faces, consecutive in the order of the tree.
    struct Range {
        std::uint32_t node, begin, end;
        bool leaf() const { return end - begin <= kLeafSize; }
    };

    /// group_of_face: [F] below `group_count`, or kNone to leave a face out.
    /// Halves the faces of each node along its longest axis.  The same faces give the same tree.
    /// O(n log n).
    FaceTree(const TriangleMesh& mesh, std::span<const std::uint32_t> group_of_face,
             std::uint32_t group_count);

    /// The whole of a group; of no faces if it is empty, then without a box.
    Range root(std::uint32_t group) const { return roots_[group]; }
    /// The halves of a node that is no leaf.
    std::array<Range, 2> children(const Range& range) const;
    const Bounds<glm::vec3>& box(const Range& range) const { return nodes_[range.node].box; }
    std::span<const FaceId> faces(const Range& range) const
    {
        return std::span(faces_).subspan(range.begin, range.end - range.begin);
    }
    std::size_t node_count() const { return nodes_.size(); }

    /// Calls visit(FaceId) for every face of a group whose leaf's box meets `box`, in the order of
    /// the tree, but for those in nodes that `skip(Range)` leaves out.
    template <typename Skip, typename Visit>
    void visit(std::uint32_t group, const Bounds<glm::vec3>& box, const Skip& skip,
               const Visit& visit_face) const
    {
        std::array<Range, 40> stack; // halving 2^32 faces goes 32 deep
        std::size_t depth = 0;
        if (!nodes_.empty())
            stack[depth++] = root(group);
        while (depth > 0) {
            const Range range = stack[--depth];
            const Bounds<glm::vec3>& here = this->box(range);
            if (glm::any(glm::lessThan(here.high, box.low)) ||
                glm::any(glm::lessThan(box.high, here.low)) || skip(range))
                continue;
            if (range.leaf()) {
                for (const FaceId face : faces(range))
                    visit_face(face);
                continue;
            }
            const auto [left, right] = children(range);
            stack[depth++] = right;
            stack[depth++] = left;
        }
    }

  private:
    static constexpr std::uint32_t kLeafSize = 4;

    /// In preorder: the left child follows.
    struct Node {
        Bounds<glm::vec3> box;
        std::uint32_t right;
    };

    struct Item {
        glm::vec3 middle{0.0f};
        FaceId face = kNone;
    };

    std::uint32_t build(const TriangleMesh& mesh, std::vector<Item>& items, std::uint32_t begin,
                        std::uint32_t end);

    std::vector<FaceId> faces_;
    std::vector<Node> nodes_;
    std::vector<Range> roots_;
};

/// The box of one face.
inline Bounds<glm::vec3> face_box(const TriangleMesh& mesh, FaceId face)
{
    Bounds<glm::vec3> box;
    for (int c = 0; c < 3; ++c)
        box.add(mesh.positions[mesh.corners[face][c]]);
    return box;
}

} // namespace hipmap
