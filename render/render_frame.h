#pragma once

#include "common/report.h"
#include "render/many/ranks.h"
#include "render/prepare_frame.h"
#include "render/previous_frame.h"
#include "render/progress_lines.h"

namespace hipmap {

/// What a frame under way listens to and talks to.
struct FrameControl {
    std::atomic<bool>& stop;        ///< set from outside, or for another process, to end early
    ProgressLines* lines = nullptr; ///< null: no program reads the progress
    Ranks* ranks = nullptr;         ///< null: one process renders
};

/// Renders a frame, or takes the image of the previous one if nothing has changed.  Writes the
/// state if one is asked for.  Moves the sky out of `frame`. previous: the previous frame, and this
/// one afterwards; null: there is a single frame.
RenderedFrame render_frame(PreparedFrame& frame, SceneSource& source, PreviousFrame* previous,
                           const FrameControl& control, Report& report);

} // namespace hipmap
