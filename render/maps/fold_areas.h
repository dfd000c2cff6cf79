#pragma once

#include "common/partition/partition.h"
#include "common/scene/mesh.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace hipmap {

/// Whose area is asked for: the surface's own, or that of its projection into the query's plane.
enum class AreaOf { surface, projection };

/// A point of a map that folds, where its faces are stored.
struct FoldQuery {
    std::uint32_t fold; ///< place among the maps that fold
    glm::dvec3 point;   ///< scene units
    glm::dvec3 normal;  ///< unit, of the point's face
    AreaOf of;
};

/// Areas of maps that fold: how much of a map that looks to the side of a point lies within a
/// radius of it, docs/visible_area.md (A9).
///
/// Borrows mesh and partition.  Read-only once built: any number of threads may query it.
class FoldAreas {
  public:
    /// Builds a tree for each map that folds.  fold_of: [maps of stored faces] its place, from 0
    /// on; kNone: it does not fold.  Cost: O(n log n), in parallel, and about 30 bytes for each
    /// face of such maps.
    FoldAreas(const TriangleMesh& mesh, const Partition& partition,
              std::span<const std::uint32_t> fold_of);

    static constexpr std::size_t kMostRadii = 3;
    using Areas = std::array<double, kMostRadii>;

    /// Returns the areas within each radius, square scene units.  radii: at most kMostRadii, >= 0,
    /// finite.  Zero where rounding has put the point off its map.  Cost: at most kMostOpen nodes,
    /// however many faces lie within the radii.
    Areas within(const FoldQuery& query, std::span<const float> radii) const;

    static constexpr std::size_t kMostOpen = 512;
    static constexpr std::uint32_t kLeafSize = 8;

    /// Faces by their sums, in a balanced tree in preorder: the left child follows its parent, and
    /// the children halve the parent's range of faces.  A range of kLeafSize faces or fewer has
    /// none.
    struct Node {
        glm::vec3 low, high;
        glm::vec3 middle; ///< of the area
        float area;
        glm::vec3 normal; ///< the mean of its faces, unit
        float alike;      ///< length of that mean before: 1 for a flat node
        float spread;     ///< sine of the half angle of a cap of directions with such a mean
        std::uint32_t right;
    };

  private:
    friend class FoldWalk;

    /// A range of faces, and the root of its tree.
    struct Tree {
        std::uint32_t begin, end, root;
    };
    static constexpr std::uint32_t kTreesOfFold = 6;

    const TriangleMesh& mesh_;
    const Partition& partition_;
    std::vector<FaceId> faces_; ///< tree by tree, in their order
    std::vector<Tree> trees_;   ///< [6 folds] of the faces that look along +x, -x, +y, ... most
    std::vector<Node> nodes_;
};

} // namespace hipmap
