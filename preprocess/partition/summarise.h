#pragma once

#include "preprocess/partition/build_partition.h"

namespace hipmap {

/// Counts what a finished partition holds, into all of its summary but `vertices`,
/// `welded_vertices`, `edges_in_band`, `joined_maps`, `given_up`, `defects` and `passes`.  Reads
/// `defects`.  Linear, one thread.
void summarise(const TriangleMesh& mesh, PartitionResult& result);

} // namespace hipmap
