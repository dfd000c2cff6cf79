#pragma once

#include <filesystem>
#include <span>
#include <vector>

namespace hipmap {

/// Returns the folders that may hold Blender's data, best first: beside the program `blender` on
/// the PATH, then where Linux distributions put it.
std::vector<std::filesystem::path> blender_folders();

/// Returns Blender's OpenColorIO configuration: datafiles/colormanagement/config.ocio below a
/// folder or below a folder of it whose name is a version (4.2), the newest first.  Throws
/// InputError if no folder holds one.
std::filesystem::path find_blender_config(std::span<const std::filesystem::path> folders);

} // namespace hipmap
