#pragma once

#include "common/command_line/option_table.h"
#include "common/scene/load_scene.h"

#include <filesystem>

namespace hipmap {

/// Which moments of an animation to work on.  Frame f is at f / fps seconds, as in Blender.
struct FrameOptions {
    int first = -1; ///< below 0: no animation, the scene as its file places it
    int last = -1;
    double fps = 24;

    bool asked() const { return first >= 0; }
};

/// --frames and --fps, bound to `frames`.
std::vector<OptionRow> frame_rows(FrameOptions& frames);

/// The file that belongs to a frame: "out.png" of frame 3 is "out.0003.png".  Empty stays empty.
std::filesystem::path frame_path(const std::filesystem::path& path, int frame);

/// Leaves only `frame` in `frames`, and sets its moment in `options`.
void set_frame(SceneOptions& options, FrameOptions& frames, int frame);

/// Calls body(frame) for all frames in order until one does not end with kExitDone; returns what
/// the last one called returned.  Without frames: body(-1).
int for_each_frame(const FrameOptions& frames, const std::function<int(int frame)>& body);

/// The same with the arguments of each frame, by arguments_of_frame; without frames with all.
template <typename Arguments, typename Body>
int for_each_frame_of(const Arguments& all, const Body& body)
{
    return for_each_frame(all.frames, [&](int frame) {
        return body(frame < 0 ? all : arguments_of_frame(all, frame));
    });
}

} // namespace hipmap
