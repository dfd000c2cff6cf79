#pragma once

#include "common/scene/raw_scene.h"

#include <filesystem>

namespace hipmap {

/// Reads an OBJ file and the MTL files it names.  One unit is one metre; polygons are cut into
/// triangles.  docs/scene.md says what the materials become.
/// texture_cache_mib: as in SceneOptions.  Throws InputError with the line or face and what is
/// wrong.
RawScene read_obj(const std::filesystem::path& path, double texture_cache_mib);

} // namespace hipmap
