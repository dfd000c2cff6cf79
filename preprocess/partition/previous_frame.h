#pragma once

#include "preprocess/partition/build_partition.h"
#include "preprocess/partition/contacts.h"
#include "preprocess/partition/group_candidates.h"
#include "preprocess/partition/self_distance.h"
#include "preprocess/partition/share_maps.h"

#include <optional>

namespace hipmap {

/// What building the partition of one animation frame keeps for the next frame.
struct PreviousFrame {
    std::vector<glm::vec3> positions;  ///< [V]
    VertexWeld weld;                   ///< of these
    std::vector<std::uint8_t> flipped; ///< [F] before seams turned any map
    FaceTree tree;                     ///< of all faces that have a map
    std::vector<MadeContact> contacts; ///< of pairs of faces
    bool found_all_contacts = true;    ///< false: some faces meet too many to look at all
    PartitionResult result;
};

/// Builds the partition of a frame, reusing the previous frame's of the same faces and options if
/// there is one, and stores it in `previous`.  The result equals build_partition(scene, options)
/// except for the seconds that passes took.  Maps that have not changed are not analysed again.
void build_partition(const Scene& scene, const PartitionOptions& options,
                     std::optional<PreviousFrame>& previous);

/// Returns find_half_edges(mesh, weld), but searches again only near faces that have moved since
/// the previous frame: faces connected to a moved vertex by the old or the new weld.  Linear, but
/// for these faces.
HalfEdges find_half_edges(const TriangleMesh& mesh, const VertexWeld& weld,
                          const PreviousFrame& previous);

/// Returns whether the previous frame's tree, refitted, is as good for a mesh as a new one: it has
/// the same faces, and few have moved.  map_of_face: [F] kNone for a face that has no place in it.
/// Linear.
bool tree_serves(const TriangleMesh& mesh, std::span<const MapId> map_of_face,
                 const PreviousFrame& previous);

/// Shared maps for which the previous frame knows everything that depends on their faces alone.
struct KnownMaps {
    std::vector<std::uint8_t> changed; ///< [maps now] 0: has the faces of one map of then, at the
                                       ///<     same places, with the same edges
    std::vector<MapId> now;            ///< [maps then] what became of a map; kNone if it changed

    bool has(MapId map) const { return map != kNone && changed[map] == 0; }
};

/// Copies what the previous frame knows of these maps to their faces; contacts get the current ids.
/// map_of_face: [F] of the current frame.  out: of all faces.  Linear.
void copy_known_self_distances(const PreviousFrame& previous, const KnownMaps& known,
                               std::span<const MapId> map_of_face, SelfDistances& out);
void copy_known_groups(const PreviousFrame& previous, const KnownMaps& known,
                       std::span<const MapId> map_of_face, GroupCandidates& out);
void append_known_contacts(const PreviousFrame& previous, const KnownMaps& known,
                           std::vector<MadeContact>& out);

/// Compares the edges and maps of a partition with the previous frame's. now: its edges, maps,
/// bridged edges and position error are set.  mesh: of the current frame.  Linear.
KnownMaps find_known_maps(const TriangleMesh& mesh, const Partition& now,
                          const PreviousFrame& previous);

} // namespace hipmap
