#pragma once

#include "render/maps/wide_search.h"

namespace hipmap {

struct NearPhoton {
    std::uint32_t slot;
    float distance2;
};

/// A photon near the point, and mostly the nearest: the nearest of the block that one comes to by
/// the nearest box on each level.  A function of tree and point alone, the same on every processor.
/// The tree is not empty; the point is finite.  Thread-safe.  Cost: a node on each level, no more.
NearPhoton near_photon(const WideTree& tree, const glm::vec3& point);

} // namespace hipmap
