#pragma once

#include "common/image/legend.h"
#include "common/scene/scene.h"
#include "preprocess/options.h"
#include "preprocess/partition/build_partition.h"

#include <string>
#include <vector>

namespace hipmap {

/// Describes the shared maps of a partition in one sentence.
std::string describe_maps(const PartitionSummary& summary);

/// Describes the candidates for local and group maps, and what they were chosen for, in one
/// sentence.
std::string describe_candidates(const PartitionSummary& summary);

/// Describes a partition in plain sentences for the user.
std::vector<std::string> describe(const PartitionSummary& summary, double angle_deg);

/// Describes the defects of the mesh and what was done about them, in sentences; empty if there
/// were none.
std::vector<std::string> describe_defects(const PartitionSummary& summary);

/// Returns the summary of a partition as JSON text, docs/partition_file.md.  Lengths in metres,
/// areas in m2.  Lists at most a thousand maps, those of the largest area. partition: of the scene.
/// pictures: the images written of it.  Near linear in faces and maps.
std::string summary_json(const PreprocessArguments& arguments, const Scene& scene,
                         const Partition& partition, const PartitionSummary& summary,
                         const std::vector<LegendedPicture>& pictures);

} // namespace hipmap
