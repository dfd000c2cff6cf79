#pragma once

#include "render/effects/effect_plan.h"
#include "render/shading/render_scene.h"

#include <string>
#include <vector>

namespace hipmap {

/// Returns the lights without a size whose light comes by smooth surfaces to others, where no path
/// from the eye finds it, docs/light_transport.md (14), such as "point light 'Lamp'".
std::vector<std::string> unreachable_lights(const RenderScene& scene, const EffectPlan& effects);

} // namespace hipmap
