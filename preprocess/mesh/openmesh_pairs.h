#pragma once

#include "common/scene/mesh.h"

namespace hipmap {

/// The neighbours that a half-edge mesh found among some faces.
struct HalfEdgePairs {
    std::vector<std::uint32_t> opposite; ///< [3F] the same edge in the face beyond, or kNone
    std::size_t refused_faces = 0;
};

/// A face to be added to the half-edge mesh.
struct WoundFace {
    FaceId id = 0;
    glm::uvec3 vertices{0u}; ///< distinct, at the corners of the mesh's face
    bool flipped = false;    ///< to be entered in reverse order
};

/// Builds an OpenMesh of the faces and reads back its pairs of half-edges.  A face it refuses is
/// added again with its own vertices, so that none is lost. vertices: below `vertex_count`.
/// face_count: F, above every id. Linear, one thread.
HalfEdgePairs pair_half_edges(std::vector<WoundFace> faces, std::uint32_t vertex_count,
                              std::size_t face_count);

} // namespace hipmap
