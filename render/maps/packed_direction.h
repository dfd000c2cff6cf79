#pragma once

#include "render/shading/lobe_batch.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

namespace hipmap {

/// A unit vector in four bytes: its projection on an octahedron that is folded into a square
/// (Cigolle et al. 2014, "A survey of efficient representations for independent unit vectors"). Off
/// by less than 1e-4 rad.
struct PackedDirection {
    std::int16_t u = 0, v = 0;
};

/// Folds the lower half of the octahedron over the upper, and back.
inline glm::vec2 fold_octahedron(const glm::vec2& p)
{
    return {std::copysign(1 - std::abs(p.y), p.x), std::copysign(1 - std::abs(p.x), p.y)};
}

/// Packs a direction.  direction: unit.  A vector with a NaN becomes an arbitrary direction.
inline PackedDirection pack_direction(const glm::vec3& direction)
{
    constexpr float kLargest = 32767;
    const float sum = std::abs(direction.x) + std::abs(direction.y) + std::abs(direction.z);
    glm::vec2 p = glm::vec2(direction) / sum;
    if (direction.z < 0)
        p = fold_octahedron(p);
    const auto rounded = [](float value) {
        return static_cast<std::int16_t>(value >= -1 ? std::lround(kLargest * std::min(1.0f, value))
                                                     : -kLargest);
    };
    return {rounded(p.x), rounded(p.y)};
}

inline glm::vec3 unpack_direction(const PackedDirection& packed)
{
    glm::vec2 p = glm::vec2(packed.u, packed.v) / 32767.0f;
    const float z = 1 - std::abs(p.x) - std::abs(p.y);
    if (z < 0)
        p = fold_octahedron(p);
    return glm::normalize(glm::vec3(p, z));
}

/// Writes the directions of some slots, 1 to kBatch, as unpack_direction returns them, the same
/// bits, several at a time.
void unpack_directions(std::span<const PackedDirection> directions,
                       std::span<const std::uint32_t> slots, DirectionBatch& out);

} // namespace hipmap
