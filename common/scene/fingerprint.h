#pragma once

#include "common/scene/scene.h"

#include <array>
#include <cstdint>

namespace hipmap {

/// 128-bit hash.
struct Fingerprint {
    std::array<std::uint64_t, 2> words{};
    bool operator==(const Fingerprint&) const = default;
};

/// Of what a partition depends on: the frame, the positions and the corners.  Not of materials,
/// lights or cameras.  Cost: linear in the mesh.
Fingerprint fingerprint(const Scene& scene);

/// Of all that light depends on: as `content_fingerprint`, without the camera.
Fingerprint still_fingerprint(const Scene& scene);

/// Of all that a texture depends on: as `fingerprint`, and normals, textures, materials, lights,
/// the sky and the camera rendered from.  Not of names.  Cost: linear in mesh and textures.
Fingerprint content_fingerprint(const Scene& scene);

} // namespace hipmap
