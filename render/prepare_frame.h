#pragma once

#include "common/partition/partition.h"
#include "common/scene/load_scene.h"
#include "render/film/render_state.h"
#include "render/lights/environment_map.h"
#include "render/options.h"
#include "render/shutter.h"

namespace hipmap {

/// Everything that is read and decided before a frame is rendered.
struct PreparedFrame {
    /// The arguments, completed by the frame: image size, photons of a pass (within --memory),
    /// diffuse model, and the light classes that are traced.
    RenderArguments arguments;
    LoadedScene loaded; ///< without what the plan leaves out
    Partition partition;
    ShutterMotion motion;
    EffectPlan effects;
    EnvironmentMap sky;
    std::vector<Setting> settings;    ///< all that its passes depend on
    std::optional<RenderState> found; ///< state to resume
    Spent reading;                    ///< all of it but the state
    Spent reading_state;
};

/// Loads the scene at a time of its animation, changed as the options say.  Throws as
/// SceneSource::at.
LoadedScene load_at(const RenderArguments& arguments, SceneSource& source,
                    std::optional<double> time);

/// Loads the scene at another moment of a frame, with the frame's partition and what `effects`
/// leave of it.  Throws as load_at.
Scene load_moment(const PreparedFrame& frame, const EffectPlan& effects, SceneSource& source,
                  double time);

/// Reads and plans the frame that `request` names, and the state to resume if its file exists.
/// With --explain sky, settings and state stay empty.  Throws as load_at, read_partition,
/// check_partition_of, load_sky, fit_memory, read_state and check_settings.
PreparedFrame prepare_frame(const RenderArguments& request, SceneSource& source);

} // namespace hipmap
