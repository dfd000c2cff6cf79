#pragma once

#include "common/scene/medium.h"

#include <filesystem>

namespace hipmap {

inline constexpr std::uint32_t kMostDensityNodes = 1 << 14;  ///< along an axis
inline constexpr std::uint64_t kMostDensityValues = 1 << 28; ///< of a grid that is written

/// Reads a density grid in the format of Mitsuba 0.6 (.vol, version 3, 32-bit floats, one channel);
/// ignores the box that the file names.  Throws InputError naming the file and the place in it:
/// another format, too short or long, fewer than 2 nodes along an axis, a value that is negative or
/// not finite.
std::shared_ptr<const DensityGrid> read_density(const std::filesystem::path& path);

/// Writes a density grid in the format that read_density reads; low, high: the box written to the
/// file.  Throws InputError if it cannot be written.
void write_density(const std::filesystem::path& path, const DensityGrid& grid, const glm::vec3& low,
                   const glm::vec3& high);

} // namespace hipmap
