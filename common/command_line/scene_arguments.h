#pragma once

#include "common/command_line/command_line.h"
#include "common/scene/load_scene.h"

namespace hipmap {

/// A picture of the sky instead of the scene's own.
struct SkyOptions {
    std::string picture;   ///< path; empty: none
    double turn_deg = 0.0; ///< of any picture, about +y, counter-clockwise from above
};

/// The options that both tools give to load_scene.
/// --camera --light-units --environment --environment-turn --exclude, into `options` and `sky`,
/// which must outlive the parsing.
void add_scene_arguments(CLI::App& app, SceneOptions& options, SkyOptions& sky);

} // namespace hipmap
