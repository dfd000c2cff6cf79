#pragma once

#include "common/scene/load_scene.h"
#include "common/setting.h"
#include "render/options.h"

#include <functional>

namespace hipmap {

/// When the shutter is open for a frame, s of the animation.
struct ShutterTime {
    double open = 0;
    double seconds = 0; ///< 0: everything is seen at one moment

    double at(double share) const { return open + share * seconds; }
};

/// --shutter frames about the moment of the frame, half of them before it, as in Blender.
ShutterTime shutter_time(const RenderArguments& arguments);

/// What a scene does while the shutter is open.
struct ShutterMotion {
    /// The names of objects, lights and the camera that are not where they are at the moment of the
    /// frame at some of five moments from the shutter's opening to its closing.
    std::vector<std::string> names;
    Setting setting; ///< for a state, besides settings_of
};

/// still: at the moment of the frame.  Loads the five moments, or nothing if the shutter is shut.
ShutterMotion find_motion(const Scene& still, const ShutterTime& shutter,
                          const std::function<Scene(double time)>& at);

} // namespace hipmap
