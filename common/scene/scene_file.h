#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace hipmap {

/// Returns the regular file `name` in the folder of `scene` or below it. Throws InputError naming
/// `place`: absolute, leaves the folder by "..", has a scheme, too long, does not exist, a folder
/// or device.
std::filesystem::path file_beside(const std::filesystem::path& scene, std::string_view place,
                                  const std::string& name);

} // namespace hipmap
