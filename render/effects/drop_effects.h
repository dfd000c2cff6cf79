#pragma once

#include "render/effects/effect_plan.h"

namespace hipmap {

/// Takes out of the scene what belongs to effects that the plan leaves out, so that rendering meets
/// a scene that never had it.  Shapes stay.  Those of LightClasses are not the scene's.
void drop_effects(Scene& scene, const EffectPlan& plan);

} // namespace hipmap
