#pragma once

#include "common/partition/partition.h"

#include <string>

namespace hipmap {

/// What is wrong with a partition, as the end of a sentence; empty if nothing is.
/// Checks the lengths of all arrays, the ranges of ids and classes, that ids of
/// maps and groups run by lowest face, that edges point back at each other and agree, and that
/// joined faces and those of a group have one map.
/// Any bytes are safe to check.  Linear.
std::string defect_of(const Partition& partition);

} // namespace hipmap
