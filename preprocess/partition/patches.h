#pragma once

#include "preprocess/partition/share_maps.h"

namespace hipmap {

/// Compact parts of shared maps.
struct Patches {
    std::vector<std::uint32_t> patch_of_face; ///< [F]; kNone for a face in no patch
    std::uint32_t count = 0;                  ///< ids are 0..count-1 by lowest face
};

/// Parts each map into patches of about 1/64 of its area, docs/partition_file.md (Groups), of at
/// least four faces each.
/// O(n log 64), parallel; the same at any thread count.
Patches find_patches(const TriangleMesh& mesh, const SharedMaps& maps);

/// Faces by a label that they have.
struct SortedFaces {
    std::vector<FaceId> faces;
    std::vector<std::size_t> first; ///< [labels + 1] where the faces of a label begin

    std::span<const FaceId> of(std::uint32_t label) const
    {
        return std::span(faces).subspan(first[label], first[label + 1] - first[label]);
    }
};

/// Sorts faces by label; those of a label keep their order, those with kNone are left out.
/// label_of_face: by FaceId, kNone or below `labels`.  Linear.
SortedFaces sort_faces(std::span<const FaceId> faces, std::span<const std::uint32_t> label_of_face,
                       std::uint32_t labels);

/// Numbers labels 0, 1, .. in the order in which they first appear; kNone stays.
/// labels: below labels.size().  Returns how many there are.  Linear.
std::uint32_t number_by_first(std::vector<std::uint32_t>& labels);

} // namespace hipmap
