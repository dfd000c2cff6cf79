#pragma once

#include "common/command_line/option_table.h"
#include "common/scene/load_scene.h"

#include <filesystem>

namespace hipmap {

/// Selects the moments of an animation to work on.  Frame f is at f / fps seconds, as in Blender.
struct FrameOptions {
    int first = -1; ///< below 0: no animation, the scene as its file places it
    int last = -1;
    double fps = 24;

    bool asked() const { return first >= 0; }
};

/// Returns the rows of --frames and --fps, bound to `frames`.
std::vector<OptionRow> frame_rows(FrameOptions& frames);

/// Returns the file name of a frame: "out.png" of frame 3 becomes "out.0003.png".  An empty path
/// stays empty.
std::filesystem::path frame_path(const std::filesystem::path& path, int frame);

/// Restricts `frames` to `frame`, and sets its time in `options`.
void set_frame(SceneOptions& options, FrameOptions& frames, int frame);

/// Calls body(frame) for all frames in order until one does not return kExitDone, and returns the
/// last result.  Without frames it calls body(-1) once.
int for_each_frame(const FrameOptions& frames, const std::function<int(int frame)>& body);

/// Calls body(arguments) for each frame in order, with the arguments of arguments_of_frame; without
/// frames, once with `all`.  Returns the result of the last call.
template <typename Arguments, typename Body>
int for_each_frame_of(const Arguments& all, const Body& body)
{
    return for_each_frame(all.frames, [&](int frame) {
        return body(frame < 0 ? all : arguments_of_frame(all, frame));
    });
}

} // namespace hipmap
