#pragma once

#include "common/command_line/option_table.h"
#include "common/scene/load_scene.h"

namespace hipmap {

/// An environment map that replaces the scene's own.
struct SkyOptions {
    std::string map_file;  ///< path; empty: none
    double turn_deg = 0.0; ///< of any environment map, about +y, counter-clockwise from above
};

/// Returns the options that both tools pass to load_scene, bound to `options` and `sky`.
std::vector<OptionRow> scene_rows(SceneOptions& options, SkyOptions& sky);

/// Returns the row of --threads, bound to `threads`.
OptionRow threads_row(unsigned& threads);

/// Returns the row of --texture-cache, bound to `mib`.
OptionRow texture_cache_row(double& mib);

/// Returns the row of --verbose, bound to `verbose`.
OptionRow verbose_row(bool& verbose);

} // namespace hipmap
