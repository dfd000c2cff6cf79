#pragma once

#include "common/partition/partition.h"

namespace hipmap {

/// Returns the rows of a partition of a mesh with copies that has them all stored: the partition of
/// the mesh after store_copies, with the same numbers of faces and maps.  mesh: as it is before.
/// Memory: that of every copy.  Throws InputError if there are more faces than edges can be
/// numbered.
Partition expand_copies(const Partition& partition, const TriangleMesh& mesh);

} // namespace hipmap
