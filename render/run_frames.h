#pragma once

#include "render/many/ranks.h"
#include "render/options.h"
#include "render/previous_frame.h"

namespace hipmap {

/// Renders the frames of a run, or its single image, and writes their files.  Returns the exit
/// code. kept: what an earlier run of the same arguments left, if its scene was a frame of the same
/// animation; this run leaves its own there.  null: nothing is kept, which a range of frames does
/// not need.  Throws InputError for bad input.
int render_frames(const RenderArguments& arguments, PreviousFrame* kept = nullptr);

/// Renders as render_frames does, as one of the processes that mpirun started.  arguments: as
/// parsed, not completed.  Returns the exit code on the lead.  Workers return kExitDone whatever
/// happens, because mpirun ends all processes when one fails, maybe before the lead printed why.
int render_in_ranks(RenderArguments arguments, Ranks& ranks);

} // namespace hipmap
