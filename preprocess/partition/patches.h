#pragma once

#include "preprocess/partition/map_trees.h"

namespace hipmap {

/// Faces of a map that stay together: all of a leaf, or one.
struct Clump {
    glm::vec3 middle{0.0f}; ///< of its box, so that the two halves of a square stay together
    std::uint32_t begin = 0, end = 0; ///< in the order of the tree
    double area = 0.0;
};

/// Compact parts of a shared map.
struct Patches {
    std::vector<Clump> clumps;        ///< by patch, then in the order of the tree
    std::vector<std::uint32_t> first; ///< [patches + 1] where the clumps of each begin

    std::span<const Clump> of(std::size_t patch) const
    {
        return std::span(clumps).subspan(first[patch], first[patch + 1] - first[patch]);
    }
};

/// Divides a map into patches of about 1/64 of its area, docs/partition_file.md (Groups), of at
/// least four faces each, and stores in `patch_of_face` one face of its patch for each face.
/// patch_of_face: [F] of the mesh, kNone at the faces of the map; stays so at faces without a
/// patch. Near linear, parallel; the same at any thread count.
Patches find_patches(const MapTree& map, std::span<std::uint32_t> patch_of_face);

/// Renumbers labels 0, 1, .. in the order of their first appearance; kNone stays. labels: below
/// labels.size().  Returns how many there are.  Linear.
std::uint32_t number_by_first(std::vector<std::uint32_t>& labels);

} // namespace hipmap
