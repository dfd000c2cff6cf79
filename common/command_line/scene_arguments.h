#pragma once

#include "common/command_line/command_line.h"
#include "common/scene/load_scene.h"

namespace hipmap {

/// The options that both tools give to load_scene.
/// --camera --light-units --environment --exclude, into `options`, which must outlive the parsing.
void add_scene_arguments(CLI::App& app, SceneOptions& options);

} // namespace hipmap
