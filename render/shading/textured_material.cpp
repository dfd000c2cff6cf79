#include "render/shading/textured_material.h"

#include <algorithm>

namespace hipmap {

namespace {

/// A vertex attribute between the corners of a face.
template <typename Value>
Value interpolate(const std::vector<Value>& values, const glm::uvec3& c,
                  const glm::vec2& barycentric)
{
    return values[c.x] * (1 - barycentric.x - barycentric.y) + values[c.y] * barycentric.x +
           values[c.z] * barycentric.y;
}

/// The texture for `use` at a point; white where the material has none.
glm::vec4 read_texture(const Scene& scene, FaceId face, const glm::vec2& barycentric,
                       TextureUse use)
{
    const Material& material = scene.materials[scene.mesh.material_of_face[face]];
    const TextureSlot* slot = find_texture(material.textures, use);
    if (slot == nullptr || scene.mesh.attributes.uv[slot->uv_set].empty())
        return glm::vec4(1);
    const glm::vec2 uv =
        interpolate(scene.mesh.attributes.uv[slot->uv_set], scene.mesh.corners[face], barycentric);
    return sample_texture(scene.images[slot->image], slot->sampler,
                          slot->uv_transform * glm::vec3(uv, 1));
}

} // namespace

MaterialPoint material_factors(const Material& material)
{
    return {material.base_color, material.metallic, material.roughness, material.transmission};
}

bool is_rendered(TextureUse use)
{
    return use == TextureUse::base_color || use == TextureUse::metallic_roughness ||
           use == TextureUse::transmission;
}

bool varies(const Material& material)
{
    return std::any_of(material.textures.begin(), material.textures.end(),
                       [](const TextureSlot& slot) { return is_rendered(slot.use); });
}

MaterialPoint material_at(const Scene& scene, FaceId face, const glm::vec2& barycentric)
{
    const auto read = [&](TextureUse use) { return read_texture(scene, face, barycentric, use); };
    MaterialPoint out = material_factors(scene.materials[scene.mesh.material_of_face[face]]);
    const glm::vec4 metallic_roughness = read(TextureUse::metallic_roughness);
    out.base_color *= Rgb(read(TextureUse::base_color));
    out.roughness *= metallic_roughness.y;
    out.metallic *= metallic_roughness.z;
    out.transmission *= read(TextureUse::transmission).x;
    return out;
}

float alpha_at(const Scene& scene, FaceId face, const glm::vec2& barycentric)
{
    float alpha = scene.materials[scene.mesh.material_of_face[face]].alpha *
                  read_texture(scene, face, barycentric, TextureUse::base_color).w;
    if (!scene.mesh.attributes.colours.empty())
        alpha *=
            interpolate(scene.mesh.attributes.colours, scene.mesh.corners[face], barycentric).w;
    return std::clamp(alpha, 0.0f, 1.0f);
}

} // namespace hipmap
