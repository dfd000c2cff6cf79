#pragma once

#include "preprocess/partition/seams.h"

namespace hipmap {

/// What `find_contacts` reads; all outlive the call.
struct ContactScene {
    const TriangleMesh& mesh;
    std::span<const EdgeClass> edge_class;        ///< [3F]
    std::span<const std::uint32_t> opposite;      ///< [3F]
    std::span<const MapId> map_of_face;           ///< [F]
    std::span<const std::uint32_t> bridged_edges; ///< ascending
    double error = 0.0;                           ///< tolerance, scene units
};

/// Appends the boundary that two faces of different maps add to each other's map: where one's edge
/// stands on the other, and where they cut through each other.  Nothing where that boundary is an
/// edge of the map already, or where the faces share an edge.
void append_contacts(const ContactScene& scene, FaceId f, FaceId g, std::vector<MapContact>& out);

/// Orders contacts by map and place, and keeps one of equal ones.
void sort_contacts(std::vector<MapContact>& contacts);

/// The contacts of all pairs of faces, sorted, none twice.
/// tree: all faces but the degenerate ones.
/// Near linear in faces and contacts, parallel; the same at any thread count.
std::vector<MapContact> find_contacts(const ContactScene& scene, const FaceTree& tree);

} // namespace hipmap
