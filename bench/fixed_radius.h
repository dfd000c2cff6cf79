#pragma once

#include "bench/query_scene.h"

#include <vector>

namespace hipmap {

/// Prints what a search for all photons within a radius costs by a hash grid, by the wide tree and
/// by a batch of all searches of an image in the wide tree, on one thread, for a radius that holds
/// some hundred photons.  queries: end points of final-gather rays in the order in which the rays
/// are traced, so that successive points lie far apart.  picture: the points of all pixels. Returns
/// whether all methods found the same photons.
bool measure_fixed_radius(const std::vector<RoomPoint>& photons,
                          const std::vector<RoomPoint>& queries,
                          const std::vector<RoomPoint>& picture);

} // namespace hipmap
