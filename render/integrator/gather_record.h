#pragma once

#include "render/paths/placed.h"

#include <cstddef>

namespace hipmap {

/// What a final-gather ray of a pilot found.
struct GatherRecord {
    Place at;                  ///< where it starts
    glm::vec3 direction{0.0f}; ///< unit
    float pdf = 0.0f;          ///< per steradian, of the lobes that drew it
    float light = 0.0f;        ///< sum of the channels of what the ray adds to its pixel, W/(m2 sr)
};

inline constexpr std::size_t kNoRecord = ~std::size_t{0};

} // namespace hipmap
