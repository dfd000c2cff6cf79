#pragma once

#include "common/image/legend.h"
#include "render/former_frame.h"
#include "render/prepare_frame.h"

#include <string>

namespace hipmap {

/// What became of the files that were asked for.
struct WrittenFiles {
    float exposure_ev = 0;
    std::optional<LegendedPicture> error_image;
    double seconds = 0; ///< writing images
    std::size_t warnings = 0;
};

/// The statistics of a render as JSON text (docs/statistics.md); powers in W.
std::string statistics_json(const PreparedFrame& frame, const RenderedFrame& rendered,
                            const WrittenFiles& written);

/// The statistics of merged states, as far as states know them.
std::string merged_statistics_json(const MergeArguments& arguments, const RenderState& state,
                                   const WrittenFiles& written);

} // namespace hipmap
