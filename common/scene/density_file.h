#pragma once

#include "common/scene/medium.h"

#include <filesystem>

namespace hipmap {

inline constexpr std::uint32_t kMostDensityNodes = 1 << 14;  ///< along an axis
inline constexpr std::uint64_t kMostDensityValues = 1 << 28; ///< of a grid that is written

/// Reads a grid of densities as Mitsuba 0.6 has it (.vol, version 3, 32-bit floats, one channel);
/// the box that the file names is passed over.  Throws InputError naming the file and the place in
/// it: another format, too short or long, fewer than 2 nodes along an axis, a value that is
/// negative or not finite.
std::shared_ptr<const DensityGrid> read_density(const std::filesystem::path& path);

/// Writes it as read_density reads it; low, high: the box that the file names.  Throws InputError
/// if it cannot be written.
void write_density(const std::filesystem::path& path, const DensityGrid& grid, const glm::vec3& low,
                   const glm::vec3& high);

} // namespace hipmap
