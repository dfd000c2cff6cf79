#pragma once

#include "preprocess/partition/build_partition.h"
#include "preprocess/partition/contacts.h"
#include "preprocess/partition/group_candidates.h"
#include "preprocess/partition/self_distance.h"
#include "preprocess/partition/share_maps.h"

#include <optional>

namespace hipmap {

/// What the partition of a frame of an animation leaves to that of the next one.
struct PreviousFrame {
    std::vector<glm::vec3> positions;  ///< [V]
    VertexWeld weld;                   ///< of these
    std::vector<std::uint8_t> flipped; ///< [F] before seams turned any map
    FaceTree tree;                     ///< of all faces that have a map
    std::vector<MadeContact> contacts; ///< of pairs of faces
    bool found_all_contacts = true;    ///< false: some faces meet too many to look at all
    PartitionResult result;
};

/// Makes the partition of a frame by that of the one before, of the same faces and options, if
/// there is one, and puts it in its place: the same, in all but the seconds that passes took, as
/// build_partition(scene, options).  Maps that have not changed keep what is known of them.
void build_partition(const Scene& scene, const PartitionOptions& options,
                     std::optional<PreviousFrame>& previous);

/// find_half_edges(mesh, weld), found anew only where something has moved since a previous frame of
/// the same faces: for those that hang together with it, by vertices that were welded then or are
/// now.  Linear, but for these faces.
HalfEdges find_half_edges(const TriangleMesh& mesh, const VertexWeld& weld,
                          const PreviousFrame& previous);

/// Whether the previous frame's tree, refitted, is as good for a mesh as one built anew: of the
/// same faces, few of which have moved.  map_of_face: [F] kNone for a face that has no place in it.
/// Linear.
bool tree_serves(const TriangleMesh& mesh, std::span<const MapId> map_of_face,
                 const PreviousFrame& previous);

/// Shared maps of which the previous frame knows all that depends on their faces alone.
struct KnownMaps {
    std::vector<std::uint8_t> changed; ///< [maps now] 0: has the faces of one map of then, at the
                                       ///<     same places, with the same edges
    std::vector<MapId> now;            ///< [maps then] what became of a map; kNone if it changed

    bool has(MapId map) const { return map != kNone && changed[map] == 0; }
};

/// What the previous frame knows of these maps, at their faces alone, contacts with the ids of now.
/// map_of_face: [F] of now.  out: of all faces.  Linear.
void copy_known_self_distances(const PreviousFrame& previous, const KnownMaps& known,
                               std::span<const MapId> map_of_face, SelfDistances& out);
void copy_known_groups(const PreviousFrame& previous, const KnownMaps& known,
                       std::span<const MapId> map_of_face, GroupCandidates& out);
void append_known_contacts(const PreviousFrame& previous, const KnownMaps& known,
                           std::vector<MadeContact>& out);

/// Compares all of a partition that is about edges and maps with the previous frame's.
/// now: its edges, maps, bridged edges and position error are set.  mesh: of now.  Linear.
KnownMaps find_known_maps(const TriangleMesh& mesh, const Partition& now,
                          const PreviousFrame& previous);

} // namespace hipmap
