#pragma once

#include "common/scene/scene_light.h"

#include <filesystem>

namespace hipmap {

/// Reads the photometric web of a luminaire from a file of IES LM-63 (.ies; 1986 to 2019, type C).
/// Its planes of symmetry are filled in, and the multiplier and ballast factors applied.  Throws
/// InputError naming the file and the line: not LM-63, type A or B, a tilt file, a number that is
/// missing or no number, angles out of order or range, a negative intensity, no light at all.
PhotometricWeb read_ies(const std::filesystem::path& path);

} // namespace hipmap
