#pragma once

#include "preprocess/partition/build_partition.h"

namespace hipmap {

/// Counts what a finished partition holds, into all of its summary but `vertices`,
/// `welded_vertices`, `edges_in_band`, `joined_maps`, `given_up`, `defects` and `passes`.  Reads
/// `defects`.  Linear, one thread.
void summarise(const TriangleMesh& mesh, PartitionResult& result);

/// Counts the candidates of a partition into `candidates`, `groups` and `grouped_faces`.  Linear,
/// parallel.
void count_candidates(const Partition& partition, PartitionSummary& summary);

/// Calls visit(map, stored map) for each map of each copy, in order of their ids.  summary.maps is
/// set.
template <typename Visit>
void for_each_copied_map(const PartitionSummary& summary, const Partition& partition,
                         const TriangleMesh& mesh, const Visit& visit)
{
    for (std::size_t i = 0; i < partition.copies.size(); ++i) {
        const SharedPart& part = partition.shared[partition.copies[i]];
        const double scale = mesh.copies[i].place.scale;
        for (MapId k = 0; k < part.map_count; ++k) {
            const PartitionSummary::Map& stored = summary.maps[part.first_map + k];
            visit(PartitionSummary::Map{partition.first_map_of_copy[i] + k, stored.faces,
                                        scale * scale * stored.area},
                  stored.id);
        }
    }
}

} // namespace hipmap
