#pragma once

#include "common/partition/partition.h"

namespace hipmap {

/// The partition of `then` for another moment, `now`, at which some of the same faces have moved.
/// Which faces share a map, and how they hang together, stays.  What depends on distances goes
/// where a face of the map has moved: its faces are no candidates for local or group maps. Contacts
/// of such maps, and those in the box of an object that has moved, are gone too, and none are found
/// anew: the estimate there is that of a map without them, off by what its radius reaches across.
/// Its fingerprint stays that of `then`.  Linear in faces, and in contacts times objects that move.
Partition partition_in_motion(const Partition& partition, const TriangleMesh& then,
                              const TriangleMesh& now);

} // namespace hipmap
