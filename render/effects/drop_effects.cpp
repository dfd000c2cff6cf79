#include "render/effects/drop_effects.h"

#include "render/lobes/ward.h"
#include "render/shading/textured_material.h"

namespace hipmap {

namespace {

/// What has a surface keeps it and what it absorbs; what has none lets everything through.
void drop_medium(Material& material)
{
    material.scattering = material.medium_emission = Rgb(0);
    material.density.reset();
    if (material.boundary)
        return;
    material.boundary = true;
    material.alpha_mode = AlphaMode::mask;
    material.alpha = 0;
    material.alpha_cutoff = 1;
}

/// Reflections spread as widely along the tangent as across it.
void drop_anisotropy(Material& material)
{
    material.anisotropy = 0;
    material.isotropy = 1;
    material.ward_slopes = glm::vec2(mean_ward_slope(material.ward_slopes));
    glm::vec3& axis = material.lafortune_coefficients;
    axis.x = axis.y = 0.5f * (axis.x + axis.y);
}

/// Removes from a material the effects that the plan leaves out.
void drop_from_material(Material& material, const EffectPlan& plan)
{
    if (!plan.has(Effect::absorption) && !material.holds_medium())
        material.absorption = Rgb(0);
    if (!plan.has(Effect::dispersion))
        material.dispersion = 0;
    if (!plan.has(Effect::clearcoat))
        material.clearcoat = 0;
    if (!plan.has(Effect::sheen))
        material.sheen_color = Rgb(0);
    if (!plan.has(Effect::diffuse_transmission))
        material.diffuse_transmission = 0;
    if (!plan.has(Effect::anisotropy))
        drop_anisotropy(material);
    if (!plan.has(Effect::reflection_models))
        material.reflection_model = ReflectionModel::metallic_roughness;
    if (!plan.has(Effect::alpha))
        material.alpha_mode = AlphaMode::opaque;
    const bool beneath = material.boundary && !is_black(material.scattering);
    if (!plan.has(beneath ? Effect::subsurface : Effect::media))
        drop_medium(material);
    if (!plan.has(Effect::normal_maps))
        std::erase_if(material.textures, [](const TextureSlot& slot) {
            return slot.use == TextureUse::normal || slot.use == TextureUse::clearcoat_normal;
        });
    if (!plan.has(Effect::textures))
        std::erase_if(material.textures,
                      [](const TextureSlot& slot) { return is_rendered(slot.use); });
}

} // namespace

void drop_effects(Scene& scene, const EffectPlan& plan)
{
    for (Material& material : scene.materials)
        drop_from_material(material, plan);
    scene.nested_dielectrics = plan.has(Effect::nested_dielectrics);
    if (!plan.has(Effect::vertex_colours))
        scene.mesh.attributes.colours.clear();
    if (!plan.has(Effect::depth_of_field))
        for (Camera& camera : scene.cameras)
            camera.aperture_radius = 0;
    if (!plan.has(Effect::media))
        scene.around = {};
    if (!plan.has(Effect::environment)) {
        scene.environment = Rgb(0);
        scene.environment_map_file.clear();
    }
}

} // namespace hipmap
