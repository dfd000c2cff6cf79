#pragma once

#include "render/maps/visible_disc.h"

#include <cstddef>
#include <cstdint>

namespace hipmap {

/// The positions of some photons, coordinate by coordinate.
struct PhotonPlaces {
    static constexpr std::size_t kMost = 64;

    alignas(64) float of[3][kMost];
    std::size_t count = 0;

    void add(const glm::vec3& position)
    {
        for (int axis = 0; axis < 3; ++axis)
            of[axis][count] = position[axis];
        ++count;
    }
};

/// Returns which of the photons VisibleDisc::sees, bit i of photon i: the same bits as one by one,
/// several at a time where the disc has few walls.  Thread-safe.
std::uint64_t seen_photons(const VisibleDisc& disc, const PhotonPlaces& photons);

} // namespace hipmap
