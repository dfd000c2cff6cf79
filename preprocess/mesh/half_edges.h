#pragma once

#include "common/partition/partition.h"
#include "preprocess/mesh/weld_vertices.h"

namespace hipmap {

/// Counts of defects in a mesh; none of them removes a face.
struct MeshDefects {
    std::size_t degenerate_faces = 0;   ///< a vertex twice, or an area of exactly zero
    std::size_t flipped_faces = 0;      ///< wound against the rest of their component
    std::size_t border_edges = 0;       ///< of one face
    std::size_t non_manifold_edges = 0; ///< of three or more faces
    std::size_t cut_edges = 0;          ///< of two faces that no winding suits
    std::size_t refused_faces = 0;      ///< that OpenMesh could not take in: none is known to be
};

/// The neighbourhood of faces as flat arrays; edges are numbered 3 face + corner.
///
///     edge of                                  class         opposite
///     two faces                                unconnected   the other one
///     one face                                 border        none
///     three or more faces                      non_manifold  none
///     two faces that no winding suits          non_manifold  none
///     a face that OpenMesh refused             non_manifold  none
///     a degenerate face                        degenerate    none
struct HalfEdges {
    std::vector<std::uint32_t> opposite; ///< [3F] the same edge in the face beyond, or kNone
    std::vector<EdgeClass> edge_class;   ///< [3F] before angles are looked at: none is connected
    std::vector<std::uint8_t> flipped;   ///< [F] as in Partition
    std::vector<std::uint8_t> closed;    ///< [F] as in Partition
    MeshDefects defects;
};

/// Finds the neighbours of every face.  The half-edge mesh is OpenMesh's; because it refuses what
/// is not an oriented manifold, faces are oriented first, and every vertex is given once to each
/// fan of faces around it (Gueziec et al. 1998, "Converting sets of polygons to manifold surfaces
/// by cutting and stitching").  Surfaces on which no edge had to be opened are manifolds as they
/// are; for these the mesh is not built.
/// Near linear; the result does not depend on threads.
HalfEdges find_half_edges(const TriangleMesh& mesh, const VertexWeld& weld);

} // namespace hipmap
