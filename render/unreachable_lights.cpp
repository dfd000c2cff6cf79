#include "render/unreachable_lights.h"

#include "common/scene/named_lights.h"

#include <algorithm>

namespace hipmap {

std::vector<std::string> unreachable_lights(const RenderScene& scene, const EffectPlan& effects)
{
    std::vector<std::string> out;
    if (!effects.has(Effect::caustics) || std::ranges::none_of(scene.bsdfs, &Bsdf::is_specular))
        return out;
    for (const NamedLight& light : named_lights(scene.scene.lights))
        if (light.emits && !light.has_size)
            out.push_back(std::string(light.kind) + " '" + light.name + "'");
    return out;
}

} // namespace hipmap
