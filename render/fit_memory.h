#pragma once

#include "render/prepare_frame.h"

namespace hipmap {

/// Lowers the light paths of a pass, and the photon cache, so that a frame keeps to the limit of
/// --memory, and notes it in the audit.  Sizes of the scene and of the image say what else needs
/// memory, by factors that docs/memory.md measures; where the limit is near, a pass of few
/// paths says how many photons a path leaves.  The result depends on scene and options alone.
/// Without --memory nothing is done.  Throws InputError if the rest alone exceeds the limit.
void fit_memory(PreparedFrame& frame);

} // namespace hipmap
