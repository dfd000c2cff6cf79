#include "render/shading/bsdf.h"

#include "render/shading/energy_compensation.h"
#include "render/shading/glossy_albedo.h"
#include "render/shading/reflection_models.h"
#include "render/shading/sheen.h"

#include <glm/glm.hpp>

#include <cmath>
#include <utility>

namespace hipmap {

namespace {

float grazing_weight(float cosine)
{
    const float m = std::clamp(1 - cosine, 0.0f, 1.0f);
    return m * m * m * m * m;
}

/// Schlick's reflectance, docs/light_transport.md (2).
Rgb schlick(const Rgb& f0, const Rgb& f90, float cosine)
{
    return f0 + (f90 - f0) * grazing_weight(cosine);
}

/// Its average over the cosine-weighted hemisphere, docs/light_transport.md (3).
Rgb schlick_average(const Rgb& f0, const Rgb& f90)
{
    return f0 + (f90 - f0) * (1.0f / 21);
}

/// No real interface reflects less than this at normal incidence: where the file asks for less, the
/// reflection is being turned off, and its grazing part goes with it (Blender's Specular 0 is
/// matt).
constexpr float kLeastReflectance = 0.02f;

/// Albedo of a reflection, whatever its width.
Rgb albedo_of(const Rgb& f0, const Rgb& f90, float cosine, float alpha)
{
    return alpha > 0 ? glossy_albedo(cosine, alpha).of(f0, f90) : schlick(f0, f90, cosine);
}

Rgb average_albedo_of(const Rgb& f0, const Rgb& f90, float alpha)
{
    return alpha > 0 ? average_glossy_albedo(alpha).of(f0, f90) : schlick_average(f0, f90);
}

/// So much of stretched facets' widths' difference is kept from the diffuse lobe below, which
/// knows the coat's albedo for one width alone: then nothing sends on more than it gets.
constexpr float kStretchedLoss = 0.15f;

/// Reflectance of the clear coat at normal incidence (its index is 1.5).
constexpr float kClearcoatF0 = 0.04f;

/// A stretched reflection is no mirror's, nor is that of a coat that may have a normal of its own:
/// across it is at least so rough.
constexpr float kLeastSpreadRoughness = 0.03f;

float roughness_of(const MaterialPoint& at)
{
    return at.anisotropy > 0 ? std::max(at.roughness, kLeastSpreadRoughness) : at.roughness;
}

/// docs/light_transport.md (31).
void stretch(float strength, Bsdf& out)
{
    if (!(strength > 0) || (out.reflection == Reflection::none && out.glass == 0))
        return;
    out.alpha_along = out.alpha + (1 - out.alpha) * strength * strength;
    const float kept = 1 - kStretchedLoss * (out.alpha_along - out.alpha);
    out.diffuse *= kept;
    out.diffuse_beyond *= kept;
}

void add_clearcoat(const Material& material, const MaterialPoint& at, Bsdf& out)
{
    if (!(at.clearcoat > 0) || at.transmission > 0)
        return;
    const float roughness = tilts(material)
                                ? std::max(at.clearcoat_roughness, kLeastSpreadRoughness)
                                : at.clearcoat_roughness;
    out.clearcoat = kind_of(roughness);
    out.clearcoat_share = at.clearcoat;
    out.clearcoat_alpha = alpha_of(roughness);
}

void add_sheen(const MaterialPoint& at, Bsdf& out)
{
    if (is_black(at.sheen_color) || at.transmission > 0)
        return;
    out.sheen = at.sheen_color;
    out.sheen_alpha = std::clamp(at.sheen_roughness, kLeastSheenAlpha, 1.0f);
}

/// What all coats and fibres keep from the diffuse lobe, averaged over the cosine-weighted
/// hemisphere. Three-point Gauss-Legendre on eight parts: the coats change fast only near grazing.
Rgb average_of_coats(const Bsdf& bsdf)
{
    constexpr int kParts = 8;
    constexpr float kOff = 0.7745966692f;
    Rgb passed(0.0f);
    for (int part = 0; part < kParts; ++part)
        for (const auto& [place, weight] : {std::pair(-kOff, 5.0f / 18), std::pair(0.0f, 8.0f / 18),
                                            std::pair(kOff, 5.0f / 18)}) {
            const float x = (static_cast<float>(part) + 0.5f * (1 + place)) / kParts;
            const float cosine = x * x; // 2 c dc = 4 x^3 dx
            passed += through_coats(bsdf, cosine) * (weight / kParts * 4 * x * x * x);
        }
    return 1.0f - passed;
}

/// docs/light_transport.md (1) and (2): the diffuse base, the coat over it, and the metal.
void make_opaque(const Material& material, const MaterialPoint& at, Bsdf& out)
{
    const float index_step = (material.ior - 1) / (material.ior + 1);
    const Rgb f0 = glm::min(index_step * index_step * at.specular_color, Rgb(1)) * at.specular;
    const Rgb f90(at.specular * std::min(1.0f, max_channel(f0) / kLeastReflectance));
    const float opaque = (1 - at.metallic) * (1 - at.transmission);
    out.coated = opaque > 0 && (!is_black(f0) || !is_black(f90));
    out.diffuse = opaque * at.base_color;
    if (out.coated) {
        out.coat_f0 = f0;
        out.coat_f90 = f90;
        out.coat_average = average_albedo_of(f0, f90, out.alpha);
    }
    if (out.clearcoat != Reflection::none || out.has_sheen())
        out.coat_average = average_of_coats(out);
    if (at.diffuse_transmission > 0 && at.transmission == 0) {
        out.diffuse_beyond = at.diffuse_transmission * opaque * at.diffuse_transmission_color;
        out.diffuse *= 1 - at.diffuse_transmission;
    }
    const Rgb below = glm::max(1.0f - out.coat_average, Rgb(1e-6f));
    out.diffuse /= below;
    out.diffuse_beyond /= below;
    out.reflect_f0 = at.metallic * at.base_color + opaque * out.coat_f0;
    out.reflect_f90 = at.metallic + opaque * out.coat_f90;
    if (!is_black(out.reflect_f0) || !is_black(out.reflect_f90))
        out.reflection = kind_of(roughness_of(at));
    if (material.energy_compensation && out.alpha > 0)
        out.regained = regained_by(at.base_color, out.alpha) * at.metallic;
}

} // namespace

Bsdf make_bsdf(const Material& material, const MaterialPoint& at, DiffuseModel model)
{
    Bsdf out;
    if (!material.boundary)
        return out; // no surface
    out.absorption = material.absorption;
    out.emission = at.emission;
    out.emits_behind = material.double_sided;
    if (material.reflection_model != ReflectionModel::metallic_roughness) {
        make_modelled(material, at, out);
        return out;
    }
    out.alpha = alpha_of(roughness_of(at));
    if (model == DiffuseModel::burley)
        out.burley_roughness = at.roughness;
    out.glass = (1 - at.metallic) * at.transmission;
    out.glass_tint = at.base_color;
    out.glass_reflection = glm::min(at.specular_color, Rgb(1)) * at.specular;
    out.ior = out.alpha > 0 ? std::max(material.ior, kLeastRoughIndex) : material.ior;
    out.dispersion = out.glass > 0 ? material.dispersion : 0;
    add_clearcoat(material, at, out);
    add_sheen(at, out);
    make_opaque(material, at, out);
    out.only_diffuse = out.glass == 0 && !out.coated && out.reflection == Reflection::none &&
                       out.clearcoat == Reflection::none && is_black(out.sheen) &&
                       is_black(out.diffuse_beyond);
    stretch(at.anisotropy, out);
    return out;
}

std::vector<Bsdf> make_bsdfs(const std::vector<Material>& materials, DiffuseModel model)
{
    std::vector<Bsdf> out;
    out.reserve(materials.size());
    for (const Material& material : materials)
        out.push_back(make_bsdf(material, material_factors(material), model));
    return out;
}

float burley_shape(const Bsdf& bsdf, const glm::vec3& normal, const glm::vec3& wi,
                   const glm::vec3& wo)
{
    // The cosine of the half angle between the directions, squared.
    const float cos2_half = 0.5f * (1 + glm::dot(wi, wo));
    const float grazing = 2 * bsdf.burley_roughness * cos2_half - 0.5f;
    return (1 + grazing * grazing_weight(glm::dot(wi, normal))) *
           (1 + grazing * grazing_weight(glm::dot(wo, normal)));
}

Bsdf clearcoat_alone(const Bsdf& bsdf)
{
    Bsdf out;
    out.reflection = bsdf.clearcoat;
    out.alpha = bsdf.clearcoat_alpha;
    out.reflect_f0 = Rgb(bsdf.clearcoat_share * kClearcoatF0);
    out.reflect_f90 = Rgb(bsdf.clearcoat_share);
    return out;
}

float clearcoat_albedo(const Bsdf& bsdf, float cosine)
{
    if (bsdf.clearcoat == Reflection::none)
        return 0;
    return bsdf.clearcoat_share *
           albedo_of(Rgb(kClearcoatF0), Rgb(1), cosine, bsdf.clearcoat_alpha).x;
}

float through_clearcoat(const Bsdf& bsdf, const Incidence& in, const Incidence& out)
{
    if (bsdf.clearcoat == Reflection::none)
        return 1;
    return (1 - clearcoat_albedo(bsdf, in.coat)) * (1 - clearcoat_albedo(bsdf, out.coat));
}

float past_sheen(const Bsdf& bsdf, float cosine)
{
    return bsdf.has_sheen() ? 1 - max_channel(bsdf.sheen) * sheen_albedo(cosine, bsdf.sheen_alpha)
                            : 1;
}

float through_layers(const Bsdf& bsdf, const Incidence& in, const Incidence& out)
{
    const float passed = through_clearcoat(bsdf, in, out);
    return bsdf.has_sheen() ? passed * past_sheen(bsdf, in.cosine) * past_sheen(bsdf, out.cosine)
                            : passed;
}

Rgb sheen_share(const Bsdf& bsdf, float cosine)
{
    return bsdf.has_sheen() ? bsdf.sheen * sheen_albedo(cosine, bsdf.sheen_alpha) : Rgb(0);
}

Rgb through_coats(const Bsdf& bsdf, const Incidence& along)
{
    const float cosine = along.cosine;
    Rgb passed =
        bsdf.coated ? 1.0f - albedo_of(bsdf.coat_f0, bsdf.coat_f90, cosine, bsdf.alpha) : Rgb(1);
    if (bsdf.has_sheen())
        passed *= past_sheen(bsdf, cosine);
    return bsdf.clearcoat == Reflection::none ? passed
                                              : passed * (1 - clearcoat_albedo(bsdf, along.coat));
}

Rgb opaque_reflectance(const Bsdf& bsdf, float cosine)
{
    return schlick(bsdf.reflect_f0, bsdf.reflect_f90, cosine);
}

Rgb reflection_albedo(const Bsdf& bsdf, float cosine)
{
    if (bsdf.reflection == Reflection::none)
        return Rgb(0);
    if (bsdf.is_modelled())
        return modelled_albedo(bsdf, cosine);
    const Rgb single = albedo_of(bsdf.reflect_f0, bsdf.reflect_f90, cosine, bsdf.alpha);
    return bsdf.is_compensated() ? single + regained_albedo(bsdf, cosine) : single;
}

SpecularLobes smooth_lobes(const Bsdf& bsdf, const Incidence& along, bool front, bool solid)
{
    const float cosine = along.cosine;
    SpecularLobes out;
    if (bsdf.is_modelled()) {
        out.mirror = modelled_mirror(bsdf, cosine);
        return out;
    }
    if (bsdf.clearcoat == Reflection::mirror)
        out.mirror = Rgb(clearcoat_albedo(bsdf, cosine));
    if (bsdf.alpha > 0)
        return out;
    if (bsdf.reflection == Reflection::mirror) {
        const Incidence image(cosine, 2 * cosine * bsdf.coat_agreement - along.coat);
        out.mirror += opaque_reflectance(bsdf, cosine) * through_layers(bsdf, along, image);
    }
    if (bsdf.glass > 0) {
        const float eta = index_beyond(bsdf, front, solid);
        const Rgb reflected = glass_reflectance(bsdf, cosine, eta);
        out.mirror += bsdf.glass * reflected;
        out.transmit = bsdf.glass * (1.0f - reflected) * bsdf.glass_tint;
        out.eta = solid ? eta : 1.0f;
    }
    return out;
}

} // namespace hipmap
