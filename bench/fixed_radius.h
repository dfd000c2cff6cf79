#pragma once

#include "bench/query_scene.h"

#include <vector>

namespace hipmap {

/// Prints what a search for all photons within a radius costs by a hash grid and by the wide tree,
/// for a radius that holds some hundred of them, on one thread.  queries: in the order of final
/// gathering, where no point is near the last one.  Returns whether both found the same photons.
bool measure_fixed_radius(const std::vector<RoomPoint>& photons,
                          const std::vector<RoomPoint>& queries);

} // namespace hipmap
