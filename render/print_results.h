#pragma once

#include "common/report.h"
#include "render/options.h"

namespace hipmap {

/// Prints what the passes did: photons, maps and map levels; warns of what was left out.
void print_statistics(const RenderArguments& arguments, const RenderStatistics& statistics,
                      const Film& film, Report& report);

/// Prints the error of the image and the price of half of it, for --quote the whole price list.
/// Nothing of a film with less than two passes.
void print_error(const RenderArguments& arguments, const RenderState& state, Report& report);

} // namespace hipmap
