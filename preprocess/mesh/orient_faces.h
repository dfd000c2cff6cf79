#pragma once

#include "preprocess/mesh/welded_faces.h"

namespace hipmap {

/// Marks the faces to flip so that neighbours have the same winding.
struct Orientation {
    std::vector<std::uint8_t> flipped;  ///< [F] 1: wound against the larger part of its component
    std::vector<std::uint32_t> partner; ///< [3F] the same edge in the one other face that has it;
                                        ///<      kNone: border, three or more faces, or cut
    std::size_t cut_edges = 0; ///< edges of two faces that no winding suits (a Moebius strip)
};

/// Orients faces.  Neighbours across an edge of exactly two faces have the same winding where they
/// run along it in opposite directions.  Of each component the part with the larger area (as
/// authored; ties go to its lowest face) is kept and the rest marked, so that no component is
/// flipped as a whole. Where a component cannot be oriented, contradicting edges are cut, along a
/// change of the authored winding. pairs: of `faces`.  Linear, one thread; degenerate faces are
/// left out.
Orientation orient_faces(const TriangleMesh& mesh, const WeldedFaces& faces, EdgePairs&& pairs);

} // namespace hipmap
