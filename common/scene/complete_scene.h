#pragma once

#include "common/scene/load_scene.h"

#include <filesystem>

namespace hipmap {

/// Supplies what a scene cannot do without and says so in the audit: a camera that frames all
/// faces if it has none, a uniform grey sky if nothing emits, one material.  Chooses the camera
/// that the options name; throws InputError, listing the names, if there is none of that name.
void complete_scene(LoadedScene& loaded, const SceneOptions& options,
                    const std::filesystem::path& path);

} // namespace hipmap
