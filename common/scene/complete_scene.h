#pragma once

#include "common/scene/load_scene.h"

#include <filesystem>

namespace hipmap {

/// Adds what a scene needs and lacks, and notes it in the audit: a camera that frames all faces, a
/// uniform grey sky if nothing emits light, one material.  Selects the camera that the options
/// name; throws InputError, listing the names, if there is none of that name.
void complete_scene(LoadedScene& loaded, const SceneOptions& options,
                    const std::filesystem::path& path);

} // namespace hipmap
