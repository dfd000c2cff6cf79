#include "preprocess/prediction/mean_material.h"

#include <algorithm>
#include <cmath>

namespace hipmap {

namespace {

/// Points of a texture that are averaged, along each side.
constexpr int kPointsAcross = 16;

/// Calls visit(value) for points spread over the texture of a use; once with white if there is
/// none.
template <typename Visit>
void visit_texture(const Scene& scene, const Material& material, TextureUse use, const Visit& visit)
{
    const TextureSlot* slot = find_texture(material.textures, use);
    if (slot == nullptr)
        return visit(glm::vec4(1.0f));
    for (int y = 0; y < kPointsAcross; ++y)
        for (int x = 0; x < kPointsAcross; ++x)
            visit(sample_texture(scene.images[slot->image], slot->sampler,
                                 (glm::vec2(x, y) + 0.5f) / float(kPointsAcross)));
}

glm::vec4 mean_of(const Scene& scene, const Material& material, TextureUse use)
{
    glm::vec4 sum(0.0f);
    float count = 0;
    visit_texture(scene, material, use, [&](const glm::vec4& value) {
        sum += value;
        ++count;
    });
    return sum / count;
}

float mean_opacity(const Scene& scene, const Material& material)
{
    if (material.alpha_mode == AlphaMode::opaque)
        return 1;
    float sum = 0, count = 0;
    visit_texture(scene, material, TextureUse::base_color, [&](const glm::vec4& value) {
        const float alpha = material.alpha * value.w;
        sum += material.alpha_mode == AlphaMode::blend ? std::min(alpha, 1.0f)
               : alpha >= material.alpha_cutoff        ? 1.0f
                                                       : 0.0f;
        ++count;
    });
    return sum / count;
}

float reflectance_of_index(float ior)
{
    const float root = (ior - 1) / (ior + 1);
    return root * root;
}

/// The roughness of a microfacet lobe about as wide as a cosine power.
float roughness_of_exponent(float exponent)
{
    return std::pow(2 / (exponent + 2), 0.25f);
}

/// Sets the reflection of models that are not glTF's.
void set_other_reflection(const Material& material, MeanMaterial& out)
{
    if (material.reflection_model == ReflectionModel::schlick) {
        out.opaque = material.roughness;
        out.reflectance = out.base_color * (1 - material.roughness);
        out.grazing = 1 - material.roughness;
        out.roughness = std::sqrt(std::sqrt(material.roughness));
        return;
    }
    const Rgb lobe = material.lobe_specular;
    out.opaque = 1;
    out.base_color *= 1.0f - lobe;
    out.reflectance = lobe;
    out.grazing = max_channel(lobe);
    out.roughness = material.reflection_model == ReflectionModel::ward
                        ? std::sqrt(std::min(material.ward_slopes.x, material.ward_slopes.y))
                        : roughness_of_exponent(material.lobe_exponent);
}

/// Sets the shares of glTF's metallic-roughness model.
void set_metallic_roughness(const Scene& scene, const Material& material, MeanMaterial& out)
{
    const auto mean = [&](TextureUse use) { return mean_of(scene, material, use); };
    const glm::vec4 metal_rough = mean(TextureUse::metallic_roughness);
    const float metallic = material.metallic * metal_rough.z;
    const float transmission = material.transmission * mean(TextureUse::transmission).x;
    out.opaque = (1 - metallic) * (1 - transmission);
    out.glass = (1 - metallic) * transmission;
    out.roughness = material.roughness * metal_rough.y;
    const float specular = material.specular * mean(TextureUse::specular).w;
    const Rgb coat = glm::min(reflectance_of_index(material.ior) * material.specular_color, Rgb(1));
    out.reflectance = metallic * out.base_color + out.opaque * specular * coat;
    out.grazing = metallic + (max_channel(coat) > 0 ? out.opaque * specular : 0);
    if (transmission > 0)
        return;
    out.through = material.diffuse_transmission * mean(TextureUse::diffuse_transmission).w;
    out.through_color =
        material.diffuse_transmission_color * Rgb(mean(TextureUse::diffuse_transmission_color));
    out.clearcoat = material.clearcoat * mean(TextureUse::clearcoat).x;
    out.coat_roughness = material.clearcoat_roughness * mean(TextureUse::clearcoat_roughness).y;
}

MeanMaterial mean_material(const Scene& scene, const Material& material)
{
    MeanMaterial out;
    out.base_color = material.base_color * Rgb(mean_of(scene, material, TextureUse::base_color));
    out.emission = material.emission * Rgb(mean_of(scene, material, TextureUse::emission));
    out.emits_behind = material.double_sided;
    out.ior = material.ior;
    out.absorption = material.absorption;
    out.opacity = mean_opacity(scene, material);
    out.boundary = material.boundary;
    if (material.reflection_model == ReflectionModel::metallic_roughness)
        set_metallic_roughness(scene, material, out);
    else
        set_other_reflection(material, out);
    return out;
}

} // namespace

std::vector<MeanMaterial> mean_materials(const Scene& scene)
{
    std::vector<MeanMaterial> out;
    out.reserve(scene.materials.size());
    for (const Material& material : scene.materials)
        out.push_back(mean_material(scene, material));
    return out;
}

bool stores_photons(const MeanMaterial& material)
{
    const bool diffuse =
        material.opaque > 0 && (max_channel(material.base_color) > 0 || material.through > 0);
    const bool rough = material.roughness > kFollowedRoughness &&
                       (material.grazing > 0 || max_channel(material.reflectance) > 0);
    const bool coat = material.clearcoat > 0 && material.coat_roughness > kFollowedRoughness;
    return material.boundary && (diffuse || rough || coat);
}

bool makes_caustics(const MeanMaterial& material)
{
    const bool smooth = material.roughness <= kFollowedRoughness &&
                        (material.grazing > 0 || max_channel(material.reflectance) > 0);
    const bool coat = material.clearcoat > 0 && material.coat_roughness <= kFollowedRoughness;
    return material.boundary && (smooth || coat || material.glass > 0);
}

} // namespace hipmap
