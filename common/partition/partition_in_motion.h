#pragma once

#include "common/partition/partition.h"

namespace hipmap {

/// Returns the partition of `then` adapted to another moment, `now`, at which some of the same
/// faces have moved. Shared maps and their connections stay.  Maps with a moved face lose what
/// depends on distances: their faces are no candidates for local or group maps.  Contacts of these
/// maps and contacts in the box of a moved object are removed and not searched again; an estimate
/// there ignores them and is biased by what its radius reaches across. The fingerprint stays that
/// of `then`.  Linear in faces, and in contacts times moved objects.
Partition partition_in_motion(const Partition& partition, const TriangleMesh& then,
                              const TriangleMesh& now);

} // namespace hipmap
