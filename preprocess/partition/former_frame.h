#pragma once

#include "preprocess/partition/build_partition.h"
#include "preprocess/partition/contacts.h"
#include "preprocess/partition/share_maps.h"

#include <optional>

namespace hipmap {

/// What the partition of a frame of an animation leaves to that of the next one.
struct FormerFrame {
    std::vector<glm::vec3> positions;  ///< [V]
    VertexWeld weld;                   ///< of these
    std::vector<std::uint8_t> flipped; ///< [F] before seams turned any map
    std::vector<MadeContact> contacts; ///< of pairs of faces
    bool found_all_contacts = true;    ///< false: some faces meet too many to look at all
    PartitionResult result;
};

/// Makes the partition of a frame by that of the one before, of the same faces and options, if
/// there is one, and puts it in its place: the same, in all but the seconds that passes took, as
/// build_partition(scene, options).  Maps that have not changed keep what is known of them.
void build_partition(const Scene& scene, const PartitionOptions& options,
                     std::optional<FormerFrame>& former);

/// find_half_edges(mesh, weld), found anew only where something has moved since a former frame of
/// the same faces: for those that hang together with it, by vertices that were welded then or are
/// now.  Linear, but for these faces.
HalfEdges find_half_edges(const TriangleMesh& mesh, const VertexWeld& weld,
                          const FormerFrame& former);

/// Shared maps of which the former frame knows all that depends on their faces alone.
struct KnownMaps {
    std::vector<std::uint8_t> changed; ///< [maps now] 0: has the faces of one map of then, at the
                                       ///<     same places, with the same edges
    std::vector<MapId> now;            ///< [maps then] what became of a map; kNone if it changed
};

/// Compares all of a partition that is about edges and maps with the former frame's.
/// now: its edges, maps, bridged edges and position error are set.  mesh: of now.  Linear.
KnownMaps find_known_maps(const TriangleMesh& mesh, const Partition& now,
                          const FormerFrame& former);

} // namespace hipmap
