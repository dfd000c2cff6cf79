#pragma once

#include "common/partition/partition.h"

#include <span>

namespace hipmap {

struct SharedMaps {
    std::vector<MapId> map_of_face; ///< [F]; kNone for a degenerate face
    std::uint32_t count = 0;
};

/// Gives every face a map; faces joined by connected edges share one.
/// edge_class, opposite: [3F], as in Partition.  Ids are 0..count-1 by lowest face.
/// Near linear (the thesis' Algorithm 2 is quadratic), one thread.
SharedMaps share_maps(std::span<const EdgeClass> edge_class,
                      std::span<const std::uint32_t> opposite);

} // namespace hipmap
