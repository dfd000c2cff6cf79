#pragma once

#include "render/options.h"

namespace hipmap {

/// Runs `render merge`: renders the image of all passes of several states, which must be of one
/// image and have no pass of a pixel in common, and says what is missing.  Returns the exit code;
/// throws InputError.
int merge_states(const MergeArguments& arguments);

/// Runs `render describe`: prints what each state holds on standard output, a line each.  Returns
/// the exit code; throws InputError.
int describe_states(const DescribeArguments& arguments);

} // namespace hipmap
