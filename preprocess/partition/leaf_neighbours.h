#pragma once

#include "preprocess/partition/face_tree.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <array>
#include <vector>

namespace hipmap {

/// Calls `find(leaf)` of a search for every leaf of the tree, in parallel.  make: () -> Search, for
/// each thread.  Returns the searches in no order.
template <typename Make>
auto search_leaves(const FaceTree& tree, const Make& make)
{
    tbb::enumerable_thread_specific<decltype(make())> searches(make);
    tbb::parallel_for(tbb::blocked_range<std::uint32_t>(0, tree.leaf_count()),
                      [&](const auto& leaves) {
                          auto& mine = searches.local();
                          for (std::uint32_t i = leaves.begin(); i < leaves.end(); ++i)
                              mine.find(tree.leaf(i));
                      });
    return searches;
}

/// A face with its box.
struct BoxedFace {
    FaceId face = kNone;
    Bounds<glm::vec3> box;
};

/// The faces near a leaf of a tree.  The faces of a leaf lie close together, so one walk through
/// the tree for all of them replaces a walk for each, and their boxes lie side by side.  For one
/// thread at a time.
class LeafNeighbours {
  public:
    /// More faces are not gathered: a leaf of large faces may have the whole scene in its box.
    static constexpr std::size_t kMost = 2048;

    /// Gathers the faces whose boxes meet `box`, in the order of the tree, without those in nodes
    /// for which `skip(Range)` is true.  Returns false, and holds nothing of use, if there are more
    /// than kMost.
    template <typename Skip>
    bool gather(const TriangleMesh& mesh, const FaceTree& tree, const Bounds<glm::vec3>& box,
                const Skip& skip)
    {
        faces_.clear();
        for (std::vector<float>& bound : bounds_)
            bound.clear();
        tree.visit(
            box, [&](const FaceTree::Range& range) { return faces_.size() > kMost || skip(range); },
            [&](FaceId face) {
                if (const BoxedFace boxed{face, face_box(mesh, face)}; meet(box, boxed.box))
                    add(boxed);
            });
        return faces_.size() <= kMost;
    }

    /// Calls visit(BoxedFace) for every gathered face whose box meets `box`, in order, while it
    /// returns true.
    template <typename Visit>
    void visit(const Bounds<glm::vec3>& box, const Visit& visit_face)
    {
        meets_.resize(faces_.size());
        find_meeting(box);
        for (std::size_t i = 0; i < faces_.size(); ++i)
            if (meets_[i] != 0 && !visit_face(faces_[i]))
                return;
    }

  private:
    void add(const BoxedFace& boxed)
    {
        faces_.push_back(boxed);
        for (int axis = 0; axis < 3; ++axis) {
            bounds_[2 * axis].push_back(boxed.box.low[axis]);
            bounds_[2 * axis + 1].push_back(boxed.box.high[axis]);
        }
    }

    /// Sets meets_.  A loop that compilers vectorise.
    void find_meeting(const Bounds<glm::vec3>& box)
    {
        const float *low_x = bounds_[0].data(), *high_x = bounds_[1].data();
        const float *low_y = bounds_[2].data(), *high_y = bounds_[3].data();
        const float *low_z = bounds_[4].data(), *high_z = bounds_[5].data();
        const std::size_t count = faces_.size();
        std::uint32_t* meets = meets_.data();
        for (std::size_t i = 0; i < count; ++i)
            meets[i] =
                std::uint32_t{box.low.x <= high_x[i]} & std::uint32_t{low_x[i] <= box.high.x} &
                std::uint32_t{box.low.y <= high_y[i]} & std::uint32_t{low_y[i] <= box.high.y} &
                std::uint32_t{box.low.z <= high_z[i]} & std::uint32_t{low_z[i] <= box.high.z};
    }

    std::vector<BoxedFace> faces_;
    std::array<std::vector<float>, 6> bounds_; ///< [2 axis + (0: low, 1: high)][i]
    std::vector<std::uint32_t> meets_;         ///< [i] 1: face i meets the box asked for
};

} // namespace hipmap
