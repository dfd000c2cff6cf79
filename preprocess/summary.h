#pragma once

#include "common/image/legend.h"
#include "common/scene/scene.h"
#include "preprocess/options.h"
#include "preprocess/partition/build_partition.h"

#include <string>
#include <vector>

namespace hipmap {

/// What a partition holds, as plain sentences for the user.
std::vector<std::string> describe(const PartitionSummary& summary, double angle_deg);

/// What was wrong with the mesh and what was done about it, as sentences; empty if nothing was.
std::vector<std::string> describe_defects(const PartitionSummary& summary);

/// The same and more as JSON text; docs/partition_file.md.  Lengths in metres, areas in m2.
/// partition: of the scene.  pictures: written of it.  O(n log n) in faces.
std::string summary_json(const PreprocessArguments& arguments, const Scene& scene,
                         const Partition& partition, const PartitionSummary& summary,
                         const std::vector<LegendedPicture>& pictures);

} // namespace hipmap
