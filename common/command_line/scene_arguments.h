#pragma once

#include "common/command_line/option_table.h"
#include "common/scene/load_scene.h"

namespace hipmap {

/// A environment map instead of the scene's own.
struct SkyOptions {
    std::string map_file;  ///< path; empty: none
    double turn_deg = 0.0; ///< of any texture, about +y, counter-clockwise from above
};

/// The options that both tools give to load_scene, bound to `options` and `sky`.
std::vector<OptionRow> scene_rows(SceneOptions& options, SkyOptions& sky);

/// --threads, bound to `threads`.
OptionRow threads_row(unsigned& threads);

} // namespace hipmap
