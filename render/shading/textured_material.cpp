#include "render/shading/textured_material.h"

#include "common/math/sampling.h"
#include "common/math/scrambled_sobol.h"

#include <algorithm>
#include <cmath>

namespace hipmap {

namespace {

/// The texture for `use` at a point; white where the material has none.
glm::vec4 read_texture(const Scene& scene, FaceId face, const glm::vec2& barycentric,
                       TextureUse use)
{
    const Material& material = scene.materials[scene.mesh.material_of(face)];
    const TextureSlot* slot = find_texture(material.textures, use);
    if (slot == nullptr || scene.mesh.attributes.uv[slot->uv_set].empty())
        return glm::vec4(1);
    return read_slot(scene, *slot, face, barycentric);
}

glm::vec4 vertex_colour(const Scene& scene, FaceId face, const glm::vec2& barycentric)
{
    return interpolate(scene.mesh.attributes.colours, scene.mesh.vertices_of(face), barycentric);
}

/// Returns the number of pixels of its texture that a face covers, clamped to 16 to 4096.
std::size_t points_on(const Scene& scene, FaceId face, TextureUse use)
{
    constexpr double kFewest = 16, kMost = 4096;
    const Material& material = scene.materials[scene.mesh.material_of(face)];
    const TextureSlot* slot = find_texture(material.textures, use);
    if (slot == nullptr || scene.mesh.attributes.uv[slot->uv_set].empty())
        return static_cast<std::size_t>(kFewest);
    const std::vector<glm::vec2>& uv = scene.mesh.attributes.uv[slot->uv_set];
    const glm::uvec3 c = scene.mesh.vertices_of(face);
    const glm::mat2 turn(slot->uv_transform);
    const glm::dvec2 a(turn * (uv[c.y] - uv[c.x])), b(turn * (uv[c.z] - uv[c.x]));
    const TextureImage& image = scene.images[slot->image];
    const double pixels = 0.5 * std::abs(a.x * b.y - a.y * b.x) * image.width * image.height;
    return static_cast<std::size_t>(pixels < kMost ? std::max(kFewest, pixels) : kMost);
}

} // namespace

glm::vec4 read_slot(const Scene& scene, const TextureSlot& slot, FaceId face,
                    const glm::vec2& barycentric)
{
    const glm::vec2 uv = interpolate(scene.mesh.attributes.uv[slot.uv_set],
                                     scene.mesh.vertices_of(face), barycentric);
    return sample_texture(scene.images[slot.image], slot.sampler,
                          slot.uv_transform * glm::vec3(uv, 1));
}

MaterialPoint material_factors(const Material& material)
{
    MaterialPoint out;
    out.base_color = material.base_color;
    out.metallic = material.metallic;
    out.roughness = material.roughness;
    out.transmission = material.transmission;
    out.emission = material.emission;
    out.specular = material.specular;
    out.specular_color = material.specular_color;
    out.clearcoat = material.clearcoat;
    out.clearcoat_roughness = material.clearcoat_roughness;
    out.sheen_color = material.sheen_color;
    out.sheen_roughness = material.sheen_roughness;
    out.anisotropy = material.anisotropy;
    out.diffuse_transmission = material.diffuse_transmission;
    out.diffuse_transmission_color = material.diffuse_transmission_color;
    return out;
}

bool is_rendered(TextureUse use)
{
    switch (use) {
    case TextureUse::base_color:
    case TextureUse::metallic_roughness:
    case TextureUse::transmission:
    case TextureUse::emission:
    case TextureUse::specular:
    case TextureUse::specular_color:
    case TextureUse::clearcoat:
    case TextureUse::clearcoat_roughness:
    case TextureUse::sheen_color:
    case TextureUse::sheen_roughness:
    case TextureUse::anisotropy:
    case TextureUse::diffuse_transmission:
    case TextureUse::diffuse_transmission_color:
        return true;
    default:
        return false;
    }
}

bool varies(const Material& material)
{
    return std::any_of(material.textures.begin(), material.textures.end(),
                       [](const TextureSlot& slot) { return is_rendered(slot.use); });
}

bool tilts(const Material& material)
{
    return find_texture(material.textures, TextureUse::normal) != nullptr ||
           (material.clearcoat > 0 && material.transmission == 0 &&
            find_texture(material.textures, TextureUse::clearcoat_normal) != nullptr);
}

std::vector<std::uint8_t> varying_materials(const Scene& scene)
{
    std::vector<std::uint8_t> out;
    for (const Material& material : scene.materials)
        out.push_back(varies(material));
    const std::vector<glm::vec4>& colours = scene.mesh.attributes.colours;
    for (FaceId face = 0; face < scene.mesh.face_count() && !colours.empty(); ++face)
        for (int c = 0; c < 3; ++c)
            if (Rgb(colours[scene.mesh.vertices_of(face)[c]]) != Rgb(1))
                out[scene.mesh.material_of(face)] = 1;
    return out;
}

MaterialPoint material_at(const Scene& scene, FaceId face, const glm::vec2& barycentric)
{
    const auto read = [&](TextureUse use) { return read_texture(scene, face, barycentric, use); };
    const Material& material = scene.materials[scene.mesh.material_of(face)];
    MaterialPoint out = material_factors(material);
    const glm::vec4 metallic_roughness = read(TextureUse::metallic_roughness);
    out.base_color *= Rgb(read(TextureUse::base_color));
    out.roughness *= metallic_roughness.y;
    out.metallic *= metallic_roughness.z;
    out.transmission *= read(TextureUse::transmission).x;
    out.emission *= Rgb(read(TextureUse::emission));
    out.specular *= read(TextureUse::specular).w;
    out.specular_color *= Rgb(read(TextureUse::specular_color));
    out.clearcoat *= read(TextureUse::clearcoat).x;
    out.clearcoat_roughness *= read(TextureUse::clearcoat_roughness).y;
    out.sheen_color *= Rgb(read(TextureUse::sheen_color));
    out.sheen_roughness *= read(TextureUse::sheen_roughness).w;
    out.anisotropy *= read(TextureUse::anisotropy).z;
    out.diffuse_transmission *= read(TextureUse::diffuse_transmission).w;
    out.diffuse_transmission_color *= Rgb(read(TextureUse::diffuse_transmission_color));
    if (!scene.mesh.attributes.colours.empty()) {
        const Rgb colour(vertex_colour(scene, face, barycentric));
        out.base_color *= colour;
        if (material.unlit) // which emits in its base colour
            out.emission *= colour;
    }
    return out;
}

Rgb mean_emission(const Scene& scene, FaceId face)
{
    const std::size_t points = points_on(scene, face, TextureUse::emission);
    Rgb sum(0.0f);
    for (std::size_t i = 0; i < points; ++i) {
        const FractionPair at = scrambled_sobol(reverse_bits(static_cast<std::uint32_t>(i)), 0);
        sum += material_at(scene, face, sample_triangle(glm::vec2(at.x >> 8, at.y >> 8) * 0x1p-24f))
                   .emission;
    }
    return sum / static_cast<float>(points);
}

float alpha_at(const Scene& scene, FaceId face, const glm::vec2& barycentric)
{
    float alpha = scene.materials[scene.mesh.material_of(face)].alpha *
                  read_texture(scene, face, barycentric, TextureUse::base_color).w;
    if (!scene.mesh.attributes.colours.empty())
        alpha *= vertex_colour(scene, face, barycentric).w;
    return std::clamp(alpha, 0.0f, 1.0f);
}

} // namespace hipmap
