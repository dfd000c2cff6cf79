#pragma once

#include "render/options.h"

namespace hipmap {

/// Runs `render merge`: renders the image of all passes of several states, which must be of one
/// render and have no pass in common.  Returns the exit code; throws InputError.
int merge_states(const MergeArguments& arguments);

} // namespace hipmap
