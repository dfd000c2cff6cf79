#pragma once

#include "common/scene/load_scene.h"
#include "common/setting.h"
#include "render/options.h"

#include <functional>

namespace hipmap {

/// The time while the shutter is open for a frame, seconds of the animation.
struct ShutterTime {
    double open = 0;
    double seconds = 0; ///< 0: everything is seen at one moment

    double at(double share) const { return open + share * seconds; }
};

/// Returns the shutter time: --shutter frames about the moment of the frame, half of them before
/// it, as in Blender.
ShutterTime shutter_time(const RenderArguments& arguments);

/// The motion in a scene while the shutter is open.
struct ShutterMotion {
    /// The names of objects, lights and the camera that move at any of five moments from the
    /// shutter's opening to its closing.
    std::vector<std::string> names;
    Setting setting; ///< for a state, besides settings_of
};

/// Finds what moves while the shutter is open.  still: the scene at the moment of the frame.  Loads
/// the five moments, or nothing if the shutter is shut.
ShutterMotion find_motion(const Scene& still, const ShutterTime& shutter,
                          const std::function<Scene(double time)>& at);

} // namespace hipmap
