#pragma once

#include "preprocess/partition/build_partition.h"
#include "render/effects/effect_plan.h"

namespace hipmap {

/// Returns the plan of a scene by its own partition.
inline EffectPlan plan_of(const Scene& scene, const EffectOptions& options = {})
{
    return plan_effects(scene, build_partition(scene, {}).partition, options);
}

} // namespace hipmap
