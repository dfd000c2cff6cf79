#pragma once

#include <cstdint>

namespace hipmap {

/// How a spot light's intensity falls off between its inner and its outer cone,
/// docs/light_transport.md (6), (39).
enum class SpotFalloff : std::uint8_t {
    gltf,          ///< the square of the place between the cosines
    smooth,        ///< smoothstep of that place: Blender since 3.5
    smooth_cosine, ///< smoothstep times the cosine to the axis, everywhere: Blender before 3.5
};

} // namespace hipmap
