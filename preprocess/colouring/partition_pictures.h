#pragma once

#include "common/image/legend.h"
#include "common/partition/partition.h"
#include "common/scene/scene.h"

#include <filesystem>
#include <vector>

namespace hipmap {

/// Writes four images of a partition, as the scene's camera sees it, into `folder`:
/// shared_maps.png, edges.png, candidates.png and groups.png, each with a legend below. width,
/// height: of the image without its legend, pixels, at least one.  The folder is made if it is
/// missing.  Throws InputError if a file cannot be written. Returns the images in this order.
/// Parallel; the same at any thread count.
std::vector<LegendedPicture> write_partition_pictures(const std::filesystem::path& folder,
                                                      const Scene& scene,
                                                      const Partition& partition, int width,
                                                      int height);

} // namespace hipmap
