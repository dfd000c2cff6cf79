#pragma once

#include "preprocess/mesh/half_edges.h"
#include "preprocess/partition/face_tree.h"
#include "preprocess/partition/share_maps.h"

namespace hipmap {

/// What `find_seams` reads; all outlive the call.
struct SeamScene {
    const TriangleMesh& mesh;
    const HalfEdges& edges;
    std::span<const EdgeClass> classes; ///< [3F], of connected edges
    const FaceTree& tree;               ///< of all faces but the degenerate ones
    double error = 0.0;                 ///< tolerance, scene units
};

struct Seams {
    SharedMaps maps;                          ///< after joining
    std::vector<std::uint8_t> turned;         ///< [maps before] 1: its faces' `flipped` must change
    std::vector<std::uint32_t> bridged_edges; ///< as in Partition
    std::vector<MapContact> open_parts;       ///< of bridged edges: where their map does end
    std::size_t given_up = 0;                 ///< edges near too many faces to look at all
};

/// Joins the maps of faces that lie in one plane, face the same way as authored, and touch along a
/// line or overlap without sharing an edge that is connected: T-junctions, abutting walls of
/// separate objects, coincident faces.  Edges beyond which such a face goes on are bridged.
/// An edge of several faces joins nothing if one of them is out of the plane.
/// Near linear, parallel; the same at any thread count.
Seams find_seams(const SeamScene& scene, const SharedMaps& maps);

} // namespace hipmap
