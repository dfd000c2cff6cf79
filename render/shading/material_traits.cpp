#include "render/shading/material_traits.h"

namespace hipmap {

// Textures only multiply, so that nothing is anywhere above its factor.

bool may_be_specular(const Material& material, const Bsdf& bsdf)
{
    return bsdf.has_mirror() || bsdf.reflects(Reflection::followed) || bsdf.glass > 0 ||
           (bsdf.clearcoat != Reflection::none &&
            find_texture(material.textures, TextureUse::clearcoat_roughness) != nullptr) ||
           find_texture(material.textures, TextureUse::metallic_roughness) != nullptr ||
           find_texture(material.textures, TextureUse::transmission) != nullptr;
}

bool may_gather_by_direction(const Material& material, const Bsdf& bsdf)
{
    if (bsdf.burley_roughness >= 0 || bsdf.clearcoat == Reflection::gathered || bsdf.has_sheen())
        return true;
    if (bsdf.is_modelled())
        return bsdf.reflection == Reflection::gathered;
    const bool may_reflect =
        material.metallic > 0 || material.specular * max_channel(material.specular_color) > 0;
    return !is_followed(material.roughness) &&
           (bsdf.reflection != Reflection::none || (varies(material) && may_reflect));
}

} // namespace hipmap
