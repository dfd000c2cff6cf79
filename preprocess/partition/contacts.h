#pragma once

#include "preprocess/partition/seams.h"

namespace hipmap {

/// The inputs of `find_contacts`; all must outlive the call.
struct ContactScene {
    const TriangleMesh& mesh;
    std::span<const EdgeClass> edge_class;        ///< [3F]
    std::span<const std::uint32_t> opposite;      ///< [3F]
    std::span<const MapId> map_of_face;           ///< [F]
    std::span<const std::uint32_t> bridged_edges; ///< ascending
    double error = 0.0;                           ///< tolerance, scene units
};

/// Appends the boundary that two faces add to their maps: where an edge of one stands on the other,
/// and where they cut through each other.  Adds nothing where that boundary is already an edge of
/// the map, where faces of different maps share an edge, or where faces of one map share a vertex
/// or are parallel.
void append_contacts(const ContactScene& scene, FaceId f, FaceId g, std::vector<MapContact>& out);

/// Sorts contacts by map and place, and removes duplicates.
void sort_contacts(std::vector<MapContact>& contacts);

/// A contact and the map of the other face that makes it, which may be the same map.
struct MadeContact {
    MapContact contact;
    MapId by = kNone;

    bool operator==(const MadeContact&) const = default;
};

/// Sorts contacts by map, place and the map that makes them, and removes duplicates.
void sort_contacts(std::vector<MadeContact>& contacts);

struct FoundContacts {
    std::vector<MadeContact> contacts; ///< sorted, none twice
    std::size_t given_up = 0;          ///< faces that meet too many larger ones to look at all
};

/// Finds the contacts between faces of different maps, at least one of which is wanted. tree: all
/// faces but the degenerate ones.  wanted: [maps] 1 for wanted maps. Near linear in faces and
/// contacts, parallel; the same at any thread count.
FoundContacts find_contacts(const ContactScene& scene, const FaceTree& tree,
                            std::span<const std::uint8_t> wanted);

/// Finds the contacts between faces of one map, for the wanted maps. self_distance: [F] as in
/// Partition; only faces whose self-distance is 0 are looked at.
FoundContacts find_own_contacts(const ContactScene& scene, const FaceTree& tree,
                                std::span<const float> self_distance,
                                std::span<const std::uint8_t> wanted);

} // namespace hipmap
