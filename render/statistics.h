#pragma once

#include "render/options.h"

#include <string>

namespace hipmap {

/// What `render` did besides rendering.
struct RunStatistics {
    SceneAudit audit;
    StopReason ended_by = StopReason::passes;
    double seconds_scene = 0; ///< reading scene and partition
    double seconds_rays = 0;  ///< building the ray tracing structure
    double seconds_write = 0; ///< writing images
    float exposure_ev = 0;
    std::size_t warnings = 0;
};

/// The statistics of a render as JSON text (docs/statistics.md); powers in W.
std::string statistics_json(const RenderArguments& arguments, const Scene& scene,
                            const Partition& partition, const RenderStatistics& render,
                            const RenderState& state, const RunStatistics& run);

/// The same of merged states, as far as states know.  seconds_write, exposure_ev, warnings of `run`
/// alone count.
std::string merged_statistics_json(const MergeArguments& arguments, const RenderState& state,
                                   const RunStatistics& run);

} // namespace hipmap
