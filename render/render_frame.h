#pragma once

#include "common/report.h"
#include "render/prepare_frame.h"
#include "render/previous_frame.h"

namespace hipmap {

/// Renders a frame, or takes the image of the previous one if nothing has changed.  Writes the
/// state if one is asked for.  Moves the sky out of `frame`. previous: the previous frame, and this
/// one afterwards; null: there is a single frame.  stop: set from outside to end early.
RenderedFrame render_frame(PreparedFrame& frame, SceneSource& source, PreviousFrame* previous,
                           const std::atomic<bool>& stop, Report& report);

} // namespace hipmap
