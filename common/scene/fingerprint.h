#pragma once

#include "common/scene/scene.h"

#include <array>
#include <cstdint>

namespace hipmap {

/// A 128-bit hash.
struct Fingerprint {
    std::array<std::uint64_t, 2> words{};
    bool operator==(const Fingerprint&) const = default;
};

/// Returns a hash of everything that a partition depends on: the frame, the positions and the
/// corners.  Materials, lights and cameras do not count.  Cost: linear in the mesh.
Fingerprint fingerprint(const Scene& scene);

/// Returns a hash of everything that the light in the scene depends on: content_fingerprint without
/// the camera.
Fingerprint still_fingerprint(const Scene& scene);

/// Returns a hash of everything that an image depends on: geometry, normals, textures, materials,
/// lights, the sky and the chosen camera, but no names.  Cost: linear in mesh and textures.
Fingerprint content_fingerprint(const Scene& scene);

} // namespace hipmap
