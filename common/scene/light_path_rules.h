#pragma once

#include <cstdint>

namespace hipmap {

// How light paths start and where they leave photons: rules of `render` by which preprocess
// predicts what it will store.

/// Up to this roughness a glossy reflection is followed, as a mirror's is; above it is gathered
/// from photons.  Rough glass is always followed.  For photons, eye paths and path tracer alike.
inline constexpr float kFollowedRoughness = 0.3f;

/// The share of light paths that all lights have in equal parts; the others go by power.
inline constexpr double kLightFloorShare = 0.1;

/// Light paths for each one that is aimed at specular surfaces besides: nearly all of those leave a
/// caustic photon, where few of the others would.
inline constexpr std::uint64_t kPathsPerCausticPath = 4;

} // namespace hipmap
