#include "render/effects/drop_effects.h"

#include "render/shading/textured_material.h"

namespace hipmap {

void drop_effects(Scene& scene, const EffectPlan& plan)
{
    for (Material& material : scene.materials) {
        if (!plan.has(Effect::absorption))
            material.absorption = Rgb(0);
        if (!plan.has(Effect::clearcoat))
            material.clearcoat = 0;
        if (!plan.has(Effect::alpha))
            material.alpha_mode = AlphaMode::opaque;
        if (!plan.has(Effect::normal_maps))
            std::erase_if(material.textures,
                          [](const TextureSlot& slot) { return slot.use == TextureUse::normal; });
        if (!plan.has(Effect::textures))
            std::erase_if(material.textures,
                          [](const TextureSlot& slot) { return is_rendered(slot.use); });
    }
    if (!plan.has(Effect::vertex_colours))
        scene.mesh.attributes.colours.clear();
    if (!plan.has(Effect::depth_of_field))
        for (Camera& camera : scene.cameras)
            camera.aperture_radius = 0;
    if (!plan.has(Effect::environment)) {
        scene.environment = Rgb(0);
        scene.environment_picture.clear();
    }
}

} // namespace hipmap
