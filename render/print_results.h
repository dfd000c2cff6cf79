#pragma once

#include "common/report.h"
#include "render/options.h"
#include "render/previous_frame.h"

namespace hipmap {

/// Prints the statistics of the passes: photons, maps and map levels; warns of what was left out.
void print_statistics(const RenderArguments& arguments, const RenderedFrame& frame, Report& report);

/// Prints the error of the image, the fireflies that carry much of it, and the cost of halving it;
/// for --quote, the whole cost table.  Prints nothing for a film with less than two passes.
void print_error(const RenderArguments& arguments, const RenderedFrame& frame, Report& report);

} // namespace hipmap
