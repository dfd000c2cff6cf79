#pragma once

#include "common/partition/partition.h"
#include "preprocess/colouring/colour_image.h"

#include <span>

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
/// Paints local-map candidates by the photons predicted on them, on a logarithmic scale from the
/// fewest to the most of them, other faces grey.  photons: [F], to outlive the painter; empty: all
/// candidates alike.
Painter paint_candidates(const Partition& partition, std::span<const float> photons);
/// Paints each group-map candidate in its own colour, darker where the limiting radius is nearer to
/// 0, other faces grey.
Painter paint_groups(const TriangleMesh& mesh, const Partition& partition);

/// The fewest and the most photons of a candidate; both 0 if there is none, or nothing predicted.
struct PhotonRange {
    float least = 0.0f;
    float largest = 0.0f;
};
PhotonRange photons_of_candidates(const Partition& partition, std::span<const float> photons);

} // namespace hipmap
