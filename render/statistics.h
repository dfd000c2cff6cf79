#pragma once

#include "render/merge_files.h"
#include "render/outputs.h"
#include "render/prepare_frame.h"
#include "render/previous_frame.h"

#include <string>

namespace hipmap {

/// Returns the statistics of a render as JSON text (docs/statistics.md); powers in W.
std::string statistics_json(const PreparedFrame& frame, const RenderedFrame& rendered,
                            const WrittenFiles& written);

/// Returns the statistics of merged states, as far as states know them.  missing: what their image
/// lacks, in pixels of the whole image.
std::string merged_statistics_json(const MergeArguments& arguments, const MergedFiles& merged,
                                   const std::vector<FilmPart>& missing,
                                   const ShownFireflies& fireflies, const WrittenFiles& written);

} // namespace hipmap
