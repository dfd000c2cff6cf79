#pragma once

#include "preprocess/partition/face_tree.h"
#include "preprocess/partition/share_maps.h"

namespace hipmap {

/// The faces of one shared map.
struct MapTree {
    const TriangleMesh& mesh;
    const FaceTree& tree; ///< all of them and no other
};

/// Builds a tree of the faces of each shared map, by id; a tree without faces where wanted[map] is
/// 0.  Each tree depends on its own faces alone. wanted: [maps.count]. Near linear, parallel; the
/// same at any thread count.
std::vector<FaceTree> trees_of_maps(const TriangleMesh& mesh, const SharedMaps& maps,
                                    std::span<const std::uint8_t> wanted);

} // namespace hipmap
