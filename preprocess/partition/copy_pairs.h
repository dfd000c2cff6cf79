#pragma once

#include "preprocess/partition/face_tree.h"

#include <vector>

namespace hipmap {

/// Finds the faces that come near each other of copies, of the shared faces where they are stored,
/// and of all other faces, without storing copies.  A place is where shared faces stand: place i,
/// below the number of shared faces, is where shared faces i are stored, and the others are the
/// copies in their order.  Read-only once built: any number of threads may use it.
class CopyPairs {
  public:
    /// map_of_face: [F] kNone for faces that no pair has.  within: scene units.  Borrows the mesh.
    CopyPairs(const TriangleMesh& mesh, std::span<const std::uint32_t> map_of_face, double within);

    std::uint32_t place_count() const { return static_cast<std::uint32_t>(placed_.size()); }
    std::uint32_t shared_of(std::uint32_t place) const { return placed_[place].shared; }

    /// Calls visit(face, other) for pairs of a face of a place and one of another place for which
    /// `wanted(place)` is true, or of no place, whose boxes come within the distance, until it
    /// returns false.  Calls it for other pairs near by, too.  Cost: logarithmic, and the faces of
    /// both that lie in the box of the other.
    template <typename Wanted, typename Visit>
    void visit(std::uint32_t place, const Wanted& wanted, const Visit& visit_pair) const
    {
        const Bounds<glm::vec3>& box = placed_[place].box;
        bool goes_on = true;
        const auto look_at = [&](const std::vector<FaceId>& others) {
            for (const FaceId other : others)
                if (goes_on)
                    goes_on = visit_near(place, other, visit_pair);
        };
        std::vector<FaceId> found;
        add_faces(rest_, {}, box, 0, found);
        look_at(found);
        place_tree_.visit(
            box, [&](const FaceTree::Range&) { return !goes_on; },
            [&](std::uint32_t other) {
                if (!goes_on || other == place || !wanted(other) || !meet(box, placed_[other].box))
                    return;
                found.clear();
                add_faces(trees_[placed_[other].shared], placed_[other].at, box,
                          placed_[other].to_scene, found);
                look_at(found);
            });
    }

  private:
    struct Placed {
        std::uint32_t shared = 0;
        Similarity at;
        std::uint32_t to_scene = 0; ///< added to a stored face
        Bounds<glm::vec3> box;      ///< widened
    };

    void add_faces(const FaceTree& tree, const Similarity& at, const Bounds<glm::vec3>& box,
                   std::uint32_t to_scene, std::vector<FaceId>& out) const;

    /// Calls visit_pair for the faces of a place near another face.
    template <typename Visit>
    bool visit_near(std::uint32_t place, FaceId other, const Visit& visit_pair) const
    {
        const Placed& own = placed_[place];
        const Bounds<glm::vec3> box = box_in(own.at, other);
        bool goes_on = true;
        trees_[own.shared].visit(
            box, [&](const FaceTree::Range&) { return !goes_on; },
            [&](FaceId face) {
                if (goes_on && meet(box, face_box(mesh_, face)))
                    goes_on = visit_pair(face + own.to_scene, other);
            });
        return goes_on;
    }

    /// The box of a face of the scene, widened, where the faces of a place are stored.
    Bounds<glm::vec3> box_in(const Similarity& at, FaceId face) const;

    const TriangleMesh& mesh_;
    double within_;
    FaceTree rest_;               ///< of faces that are not shared
    std::vector<FaceTree> trees_; ///< [shared]
    std::vector<Placed> placed_;  ///< [places]
    TriangleMesh boxes_;          ///< a triangle for each place, with its box
    FaceTree place_tree_;         ///< of these
};

} // namespace hipmap
