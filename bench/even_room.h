#pragma once

#include "render/dissertation/dissertation.h"

#include <cstddef>
#include <vector>

namespace hipmap {

/// Photons spread evenly over the inside of a unit cube, in independent sets: the irradiance is 1
/// wherever one looks, right up to the edges and corners where its walls meet.  They come from all
/// directions, as from an even sky.
struct EvenRoomOptions {
    MapOptions maps = {};
    DissertationOptions dissertation = {};
    std::size_t photons = 6000; ///< of a set; each wall gets a sixth
    std::size_t sets = 10'000;
    bool dark_floor = false; ///< nothing falls on the floor: the irradiance there is 0
};

/// Estimates of the irradiance at points of the floor, x and y in [0, 1]: [points][sets].
/// Returns estimates by sets of photons; estimates of one set are not independent of each other.
/// Same options, same numbers.
std::vector<std::vector<double>> estimates_in_even_room(const std::vector<glm::vec2>& points,
                                                        const EvenRoomOptions& options);

} // namespace hipmap
