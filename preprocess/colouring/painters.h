#pragma once

#include "common/partition/partition.h"
#include "preprocess/colouring/colour_image.h"

namespace hipmap {

/// Colours of edges.png, by EdgeClass.
Rgb edge_colour(EdgeClass edge_class);

/// The grey of faces that have nothing to show.
inline constexpr Rgb kPlainFace{0.5f};

/// What the partition's pictures show.  The mesh and the partition must outlive the painter.
/// Every shared map in its colour.
Painter paint_maps(const Partition& partition);
/// The edges of faces as lines of 1.5 pixels, by class; where lines overlap the rarer class wins.
Painter paint_edges(const TriangleMesh& mesh, const Partition& partition);
/// Candidates by reach on a logarithmic scale from the least to the largest of them, other faces
/// grey.
Painter paint_candidates(const Partition& partition);
/// Candidates for group maps in a colour each, the darker the nearer the limiting radius is to 0,
/// other faces grey.
Painter paint_groups(const TriangleMesh& mesh, const Partition& partition);

/// Least and largest reach of the candidates, scene units; both 0 if there is none.
struct ReachRange {
    float least = 0.0f;
    float largest = 0.0f;
};
ReachRange reach_of_candidates(const Partition& partition);

} // namespace hipmap
