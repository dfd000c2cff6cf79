#pragma once

#include "common/report.h"
#include "render/options.h"

namespace hipmap {

/// Plans the effects of a run, completes the options by the plan, and removes from the scene what
/// it leaves out.  moving: names of what moves while the shutter is open.
EffectPlan plan_run(RenderArguments& arguments, Scene& scene, const Partition& partition,
                    std::vector<std::string> moving);

/// Prints all effects, a line each.
void explain(const EffectPlan& plan, Report& report);

} // namespace hipmap
