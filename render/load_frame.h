#pragma once

#include "common/partition/partition.h"
#include "common/scene/load_scene.h"
#include "render/options.h"
#include "render/shutter.h"

namespace hipmap {

/// The scene of a frame, ready to be rendered by its plan.
struct FrameScene {
    LoadedScene loaded; ///< without what the plan leaves out
    Partition partition;
    ShutterMotion motion;
    EffectPlan effects;
};

/// The scene at a time of its animation, with what the options say of it.  Throws as
/// SceneSource::at.
LoadedScene load_at(const RenderArguments& arguments, SceneSource& source,
                    std::optional<double> time);

/// The scene at another moment of a frame, with the partition and the plan of that frame.  Throws
/// as load_at.
Scene load_moment(const RenderArguments& arguments, SceneSource& source, double time,
                  const Partition& partition, const EffectPlan& effects);

/// The scene of the frame that the options name.  Completes the options: image size, photons of a
/// pass, diffuse model, and the light classes that are traced.  Throws as load_at, read_partition
/// and check_partition_of.
FrameScene load_frame(RenderArguments& arguments, SceneSource& source);

} // namespace hipmap
