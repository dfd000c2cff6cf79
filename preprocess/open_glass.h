#pragma once

#include "common/partition/partition.h"
#include "common/scene/scene.h"

#include <string>
#include <vector>

namespace hipmap {

/// Returns a sentence for each object of a material that transmits whose surface is open, so that
/// it is rendered as a thin pane; of many objects for the first few, and one for the rest.
/// partition: of the scene.  Linear.
std::vector<std::string> describe_open_glass(const Scene& scene, const Partition& partition);

} // namespace hipmap
