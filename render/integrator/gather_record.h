#pragma once

#include "common/scene/mesh.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace hipmap {

/// What a final-gather ray of a pilot found.
struct GatherRecord {
    glm::vec3 position{0.0f};  ///< where it starts, scene units
    glm::vec3 direction{0.0f}; ///< unit
    FaceId face = kNone;
    std::uint8_t side = 0;
    float pdf = 0.0f;   ///< per steradian, of the lobes that drew it
    float light = 0.0f; ///< sum of the channels of what the ray adds to its pixel, W/(m2 sr)
};

inline constexpr std::size_t kNoRecord = ~std::size_t{0};

} // namespace hipmap
