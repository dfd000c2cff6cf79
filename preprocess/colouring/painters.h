#pragma once

#include "common/partition/partition.h"
#include "preprocess/colouring/colour_image.h"

namespace hipmap {

/// Returns the colour of an edge class in edges.png.
Rgb edge_colour(EdgeClass edge_class);

/// The grey of faces that have nothing to show.
inline constexpr Rgb kPlainFace{0.5f};

/// Paints every shared map in its colour.  The mesh and the partition must outlive the painter.
Painter paint_maps(const Partition& partition);
/// Paints the edges of faces as lines of 1.5 pixels, by class; where lines overlap the rarer class
/// wins.
Painter paint_edges(const TriangleMesh& mesh, const Partition& partition);
/// Paints local-map candidates by reach on a logarithmic scale from the least to the largest of
/// them, other faces grey.
Painter paint_candidates(const Partition& partition);
/// Paints each group-map candidate in its own colour, darker where the limiting radius is nearer to
/// 0, other faces grey.
Painter paint_groups(const TriangleMesh& mesh, const Partition& partition);

/// The least and largest reach of the candidates, scene units; both 0 if there is none.
struct ReachRange {
    float least = 0.0f;
    float largest = 0.0f;
};
ReachRange reach_of_candidates(const Partition& partition);

} // namespace hipmap
