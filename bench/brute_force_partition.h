#pragma once

#include "common/partition/partition.h"

#include <string>

namespace hipmap {

/// Compares a partition with what the rules of docs/partition_file.md say of the mesh, applied one
/// by one to all pairs of vertices, edges and faces, by code that shares nothing with preprocess:
/// classes and opposites of all edges, maps of all faces, and windings along connected edges.
/// Which edges of a surface with one side are cut is free; of these it takes the partition's, and
/// checks that each is needed and that none is missing.
/// partition: by angle, without a weld distance.  Returns what differs first, in words; empty if
/// nothing does.  Cost: square of the faces, one thread.
std::string difference_from_brute_force(const TriangleMesh& mesh, const Partition& partition);

} // namespace hipmap
