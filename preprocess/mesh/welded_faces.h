#pragma once

#include "common/scene/mesh.h"
#include "preprocess/mesh/weld_vertices.h"

namespace hipmap {

/// The faces of a mesh by welded vertex.  Edge 3 f + c of face f runs from corner c to corner (c +
/// 1) mod 3, as in Partition.
struct WeldedFaces {
    std::vector<std::uint32_t> vertex_of_corner; ///< [3F] welded
    std::vector<std::uint8_t> degenerate; ///< [F] 1: a vertex twice, or an area of exactly zero
    std::uint32_t vertex_count = 0;

    std::uint32_t start(std::uint32_t edge) const { return vertex_of_corner[edge]; }
    std::uint32_t end(std::uint32_t edge) const
    {
        return vertex_of_corner[edge % 3 == 2 ? edge - 2 : edge + 1];
    }
};

/// Looks every corner up in the weld and finds the degenerate faces.  Linear, parallel.
WeldedFaces weld_faces(const TriangleMesh& mesh, const VertexWeld& weld);

/// Edges grouped by their two vertices.
struct EdgeGroups {
    std::vector<std::uint32_t> edges;    ///< by group; ascending within one
    std::vector<std::uint32_t> first{0}; ///< [G + 1] where each group begins in `edges`

    std::size_t count() const { return first.size() - 1; }
};

/// The edges of all non-degenerate faces, by how many have the same two vertices.
struct EdgePairs {
    std::vector<std::uint32_t>
        partner; ///< [3F] the one other edge with the same vertices, or kNone
    EdgeGroups
        others; ///< of one edge or of more than two, by their lower, then their higher vertex
    bool wound_alike = true; ///< partners run in opposite directions, all of them
};

/// Pairs the edges of faces.  parts: of the vertices, each for a thread; the result does not depend
/// on it.  Near linear, parallel.
EdgePairs pair_edges(const WeldedFaces& faces, std::size_t parts);

} // namespace hipmap
