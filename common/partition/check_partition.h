#pragma once

#include "common/partition/partition.h"

#include <string>

namespace hipmap {

/// Returns what is wrong with a partition, as the end of a sentence; empty if nothing is. Checks
/// the lengths of all arrays, the ranges of ids and classes, that ids of maps and groups are
/// ordered by lowest face, that opposite edges point to each other and agree, and that joined faces
/// and the faces of a group have one map. Safe for any bytes.  Linear.
std::string defect_of(const Partition& partition);

} // namespace hipmap
