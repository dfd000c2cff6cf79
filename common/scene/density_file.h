#pragma once

#include "common/scene/medium.h"

#include <filesystem>

namespace hipmap {

/// Reads a grid of densities as Mitsuba 0.6 has it (.vol, version 3, 32-bit floats, one channel);
/// the box that the file names is passed over.  Throws InputError naming the file and the place in
/// it: another format, too short or long, fewer than 2 nodes along an axis, a value that is
/// negative or not finite.
std::shared_ptr<const DensityGrid> read_density(const std::filesystem::path& path);

} // namespace hipmap
