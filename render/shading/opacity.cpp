#include "render/shading/opacity.h"

#include "render/shading/textured_material.h"

#include <algorithm>

namespace hipmap {

namespace {

float covered_share(const Scene& scene, FaceId face, const glm::vec2& barycentric)
{
    const Material& material = scene.materials[scene.mesh.material_of(face)];
    const float alpha = alpha_at(scene, face, barycentric);
    if (material.alpha_mode == AlphaMode::mask)
        return alpha >= material.alpha_cutoff ? 1.0f : 0.0f;
    return alpha;
}

} // namespace

bool may_let_light_pass(const Scene& scene, const Material& material)
{
    if (material.alpha_mode == AlphaMode::opaque || !material.boundary)
        return false;
    const TextureSlot* slot = find_texture(material.textures, TextureUse::base_color);
    const float least = material.alpha_mode == AlphaMode::mask ? material.alpha_cutoff : 1.0f;
    return material.alpha < least || (slot != nullptr && has_alpha(scene.images[slot->image])) ||
           std::any_of(scene.mesh.attributes.colours.begin(), scene.mesh.attributes.colours.end(),
                       [](const glm::vec4& colour) { return colour.w < 1; });
}

Opacity opacity_of(const Scene& scene)
{
    std::vector<std::uint8_t> partly;
    for (const Material& material : scene.materials)
        partly.push_back(may_let_light_pass(scene, material));
    const std::vector<MaterialId>& worn = scene.mesh.material_of_face;
    if (std::none_of(worn.begin(), worn.end(), [&](MaterialId m) { return partly[m] != 0; }))
        return {};
    return [&scene, partly = std::move(partly)](FaceId face, const glm::vec2& barycentric) {
        return partly[scene.mesh.material_of(face)] == 0 ? 1.0f
                                                         : covered_share(scene, face, barycentric);
    };
}

} // namespace hipmap
