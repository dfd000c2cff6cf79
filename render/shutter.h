#pragma once

#include "common/scene/load_scene.h"
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

/// The names of objects, lamps and the camera that are not where they are in `still` at some of
/// five moments from the shutter's opening to its closing.
std::vector<std::string> find_moving(const Scene& still, const ShutterTime& shutter,
                                     const std::function<Scene(double time)>& at);

/// What a state says of the shutter, besides what settings_of does.
std::string shutter_setting(const ShutterTime& shutter,
                            const std::function<Scene(double time)>& at);

} // namespace hipmap
