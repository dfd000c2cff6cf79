#pragma once

#include "common/image/legend.h"
#include "common/partition/partition.h"
#include "common/scene/scene.h"

#include <filesystem>
#include <span>
#include <vector>

namespace hipmap {

/// What images of a partition show.
struct PartitionView {
    const Scene& scene;
    const Partition& partition;
    bool candidates = false;          ///< for local and group maps as well
    std::span<const float> photons{}; ///< [F] predicted on each face; empty: not predicted
};

/// Writes images of a partition, as the scene's camera sees it, into `folder`: shared_maps.png and
/// edges.png, with candidates also candidates.png and groups.png, each with a legend below. width,
/// height: of the image without its legend, pixels, at least one.  The folder is made if it is
/// missing.  Throws InputError if a file cannot be written. Returns the images in this order.
/// Parallel; the same at any thread count.
std::vector<LegendedPicture> write_partition_pictures(const std::filesystem::path& folder,
                                                      const PartitionView& shown, int width,
                                                      int height);

} // namespace hipmap
