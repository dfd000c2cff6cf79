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

/// Appends the boundary that two faces add to their maps: where one's edge stands on the other, and
/// where they cut through each other.  Nothing where that boundary is an edge of the map already,
/// where faces of different maps share an edge, or where faces of one map share a vertex or are
/// parallel.
void append_contacts(const ContactScene& scene, FaceId f, FaceId g, std::vector<MapContact>& out);

/// Orders contacts by map and place, and keeps one of equal ones.
void sort_contacts(std::vector<MapContact>& contacts);

/// A contact and the map of the other face that makes it, which may be the same one.
struct MadeContact {
    MapContact contact;
    MapId by = kNone;

    bool operator==(const MadeContact&) const = default;
};

/// Orders contacts by map, place and what makes them, and keeps one of equal ones.
void sort_contacts(std::vector<MadeContact>& contacts);

struct FoundContacts {
    std::vector<MadeContact> contacts; ///< sorted, none twice
    std::size_t given_up = 0;          ///< faces that meet too many larger ones to look at all
};

/// The contacts of pairs of faces of different maps, all that have a face of some maps and perhaps
/// others.
/// tree: all faces but the degenerate ones.  wanted: [maps] 1 for those maps.
/// Near linear in faces and contacts, parallel; the same at any thread count.
FoundContacts find_contacts(const ContactScene& scene, const FaceTree& tree,
                            std::span<const std::uint8_t> wanted);

/// The contacts of all pairs of faces of one map, of the maps that are wanted.
/// self_distance: [F] as in Partition; only faces that have none need be looked at.
FoundContacts find_own_contacts(const ContactScene& scene, const FaceTree& tree,
                                std::span<const float> self_distance,
                                std::span<const std::uint8_t> wanted);

} // namespace hipmap
