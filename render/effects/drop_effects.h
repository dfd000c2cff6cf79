#pragma once

#include "render/effects/effect_plan.h"

namespace hipmap {

/// Removes from the scene what belongs to effects that the plan leaves out, so that rendering sees
/// a scene that never had it.  Shapes stay.  Effects of LightClasses are switched off in the
/// integrator, not in the scene.
void drop_effects(Scene& scene, const EffectPlan& plan);

} // namespace hipmap
