#pragma once

#include "common/scene/scene.h"

#include <array>
#include <cstdint>

namespace hipmap {

/// 128-bit hash of what a partition depends on: the frame, the positions and the corners.
/// Not of materials, lights or cameras.  Cost: linear in the mesh.
struct Fingerprint {
    std::array<std::uint64_t, 2> words{};
    bool operator==(const Fingerprint&) const = default;
};

Fingerprint fingerprint(const Scene& scene);

} // namespace hipmap
