#pragma once

#include "preprocess/partition/face_tree.h"
#include "preprocess/partition/share_maps.h"

namespace hipmap {

/// Faces of a map that stay together: all of a leaf, or one.
struct Clump {
    glm::vec3 middle{0.0f}; ///< of its box, so that the two halves of a square stay together
    std::uint32_t begin = 0, end = 0; ///< in the order of the tree
    MapId map = kNone;
    double area = 0.0;
};

/// Compact parts of shared maps.
struct Patches {
    std::vector<Clump> clumps;                ///< by patch, then in the order of the tree
    std::vector<std::uint32_t> first;         ///< [patches + 1] where the clumps of each begin
    std::vector<std::uint32_t> patch_of_face; ///< [F] one of its faces; kNone for a face in none

    std::span<const Clump> of(std::size_t patch) const
    {
        return std::span(clumps).subspan(first[patch], first[patch + 1] - first[patch]);
    }
};

/// Parts each map into patches of about 1/64 of its area, docs/partition_file.md (Groups), of at
/// least four faces each.
/// tree: all faces that have a map.  map_of_node: its labels_of_nodes by map.
/// Near linear, parallel; the same at any thread count.
Patches find_patches(const TriangleMesh& mesh, const SharedMaps& maps, const FaceTree& tree,
                     std::span<const MapId> map_of_node);

/// Numbers labels 0, 1, .. in the order in which they first appear; kNone stays.
/// labels: below labels.size().  Returns how many there are.  Linear.
std::uint32_t number_by_first(std::vector<std::uint32_t>& labels);

} // namespace hipmap
