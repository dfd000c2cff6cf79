#pragma once

#include "preprocess/mesh/welded_faces.h"

namespace hipmap {

/// Which faces must be turned so that neighbours are wound alike.
struct Orientation {
    std::vector<std::uint8_t> flipped;  ///< [F] 1: wound against the larger part of its component
    std::vector<std::uint32_t> partner; ///< [3F] the same edge in the one other face that has it;
                                        ///<      kNone: border, three or more faces, or cut
    std::size_t cut_edges = 0; ///< edges of two faces that no winding suits (a Moebius strip)
};

/// Neighbours across an edge of exactly two faces are wound alike where they run along it in
/// opposite directions.  Of each component the part with the larger area (as it was authored; ties
/// go to its lowest face) is kept and the rest marked, so that no component is turned as a whole.
/// Where a component cannot be oriented, edges that contradict are cut, along a change of the
/// authored winding.
/// Linear, one thread; degenerate faces are left out.
Orientation orient_faces(const TriangleMesh& mesh, const WeldedFaces& faces,
                         const EdgeGroups& groups);

} // namespace hipmap
