#pragma once

#include "common/partition/partition.h"
#include "common/scene/mesh.h"

#include <vector>

namespace hipmap {

/// Returns the shared faces of a mesh with their maps.  Empty if some have a neighbour or a map
/// with faces outside.  partition: of the stored faces; its edges and maps are set.
std::vector<SharedPart> find_shared_parts(const TriangleMesh& mesh, const Partition& partition);

/// Returns the places, ascending, as set_apart has them, where shared faces or their copies may be
/// one surface with other faces: two corners of a face coincide with two of another one, or an edge
/// where a surface may go on lies on a face in its plane, docs/partition_file.md.  Their maps are
/// not those of other copies.  Near linear, parallel; the same at any thread count.
std::vector<std::uint32_t> find_joined_places(const TriangleMesh& mesh, const Partition& partition);

/// Appends the contacts of copies with all other faces, by map: to own_contacts those of maps of
/// shared faces and copies, to contacts those of other maps.  partition: with its copies and the
/// contacts of stored faces.  Near linear, parallel; the same at any thread count.
void add_copy_contacts(const TriangleMesh& mesh, Partition& partition);

} // namespace hipmap
