#pragma once

#include "common/report.h"
#include "render/options.h"

namespace hipmap {

/// Plans the effects of a run, completes the options by the plan, and takes what it leaves out from
/// the scene.
EffectPlan plan_run(RenderArguments& arguments, Scene& scene, const Partition& partition);

/// Prints all effects, a line each.
void explain(const EffectPlan& plan, Report& report);

} // namespace hipmap
