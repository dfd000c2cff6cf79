#pragma once

#include "common/command_line/picture_size.h"

#include <algorithm>
#include <cstdint>

namespace hipmap {

/// Pixels across an image, and mean samples of a pixel in a pass, where options do not say.
inline constexpr int kDefaultWidth = 512;
inline constexpr int kDefaultSamples = 4;

/// Bounds of the light paths of a pass where --photons is not given.
inline constexpr std::uint64_t kFewestDefaultPhotons = 200'000;
inline constexpr std::uint64_t kMostDefaultPhotons = 2'000'000;

/// Returns as many light paths as a pass has samples, within bounds: photons then cost a small part
/// of a pass and are about as dense as the rays that read them.  Fewer photons save little
/// time, and maps of more would fill the memory.  size: complete.
inline std::uint64_t default_photons(const PictureSize& size, int samples)
{
    const std::uint64_t pixels = static_cast<std::uint64_t>(size.width) * size.height;
    return std::clamp(pixels * samples, kFewestDefaultPhotons, kMostDefaultPhotons);
}

/// Upper bounds of --photons and --neighbours.
inline constexpr double kMostPhotons = 4e9;
inline constexpr double kMostNeighbours = 1e6;

} // namespace hipmap
