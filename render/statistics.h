#pragma once

#include "render/outputs.h"
#include "render/prepare_frame.h"
#include "render/previous_frame.h"

#include <string>

namespace hipmap {

/// Returns the statistics of a render as JSON text (docs/statistics.md); powers in W.
std::string statistics_json(const PreparedFrame& frame, const RenderedFrame& rendered,
                            const WrittenFiles& written);

/// Returns the statistics of merged states, as far as states know them.
std::string merged_statistics_json(const MergeArguments& arguments, const RenderState& state,
                                   const std::optional<Fireflies>& fireflies,
                                   const WrittenFiles& written);

} // namespace hipmap
