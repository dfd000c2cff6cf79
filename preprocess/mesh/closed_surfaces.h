#pragma once

#include "preprocess/mesh/half_edges.h"

namespace hipmap {

/// Marks the faces of surfaces that enclose a volume: connected across opposite edges, without a
/// border or non-manifold edge, of four faces or more, and with a volume that is not lost in the
/// rounding of its area (so a sheet with two coincident sides is open).
/// Returns [F].  Near linear, one thread.
std::vector<std::uint8_t> find_closed_surfaces(const TriangleMesh& mesh, const HalfEdges& edges);

} // namespace hipmap
