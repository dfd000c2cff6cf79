#include "render/shading/material_traits.h"

namespace hipmap {

// Textures only multiply, so that nothing is anywhere above its factor.

bool may_be_specular(const Material& material, const Bsdf& bsdf)
{
    return bsdf.is_specular || bsdf.follows ||
           (bsdf.layers.clearcoat > 0 &&
            find_texture(material.textures, TextureUse::clearcoat_roughness) != nullptr) ||
           find_texture(material.textures, TextureUse::metallic_roughness) != nullptr ||
           find_texture(material.textures, TextureUse::transmission) != nullptr;
}

bool may_gather_by_direction(const Material& material, const Bsdf& bsdf)
{
    if (!bsdf.is_separable)
        return true;
    if (material.reflection_model != ReflectionModel::metallic_roughness)
        return false;
    if (material.diffuse_model != DiffuseModel::lambert)
        return true;
    const bool may_reflect =
        material.metallic > 0 || material.specular * max_channel(material.specular_color) > 0;
    return handled_at(material.roughness) == Lobes::gathered &&
           (has_reflection(bsdf) || (varies(material) && may_reflect));
}

} // namespace hipmap
