#pragma once

#include "preprocess/mesh/half_edges.h"
#include "preprocess/mesh/welded_faces.h"

namespace hipmap {

/// Marks the faces of surfaces that enclose a volume: connected without a border, of four faces or
/// more, and with a volume that is not lost in the rounding of its area (so a sheet with two
/// coincident sides is open).  Surfaces that only touch stay whole: on an edge of several faces,
/// the two faces of one object belong together.  A border along a face without area is a crack
/// without width and does not count, nor do pinholes: borders of at most 1e-3 times the square root
/// of the area, in all.  others: those of pair_edges.  Does not read `edges.closed`.  Returns [F].
/// Near linear, parallel; the same at any thread count.
std::vector<std::uint8_t> find_closed_surfaces(const TriangleMesh& mesh, const WeldedFaces& faces,
                                               const EdgeGroups& others, const HalfEdges& edges);

} // namespace hipmap
