#pragma once

#include "common/image/legend.h"
#include "render/effects/effect_plan.h"
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
    std::optional<LegendedPicture> error_image;
    std::size_t warnings = 0;
    EffectPlan effects;
};

/// The statistics of a render as JSON text (docs/statistics.md); powers in W.
std::string statistics_json(const RenderArguments& arguments, const Scene& scene,
                            const Partition& partition, const RenderStatistics& render,
                            const RenderState& state, const RunStatistics& run);

/// The same of merged states, as far as states know.  Of `run` what was written and warned of
/// counts.
std::string merged_statistics_json(const MergeArguments& arguments, const RenderState& state,
                                   const RunStatistics& run);

} // namespace hipmap
