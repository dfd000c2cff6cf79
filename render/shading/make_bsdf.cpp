#include "render/shading/make_bsdf.h"

#include "render/lobes/cosine_power.h"
#include "render/lobes/multiple_scattering.h"
#include "render/lobes/sheen_albedo.h"

#include <algorithm>
#include <cmath>

namespace hipmap {

namespace {

/// No real interface reflects less than this at normal incidence: where the file asks for less, the
/// reflection is being turned off, and its grazing part goes with it (Blender's Specular 0 is
/// diffuse).
constexpr float kLeastReflectance = 0.02f;

/// The diffuse lobe below anisotropic facets loses this part of the difference of their widths,
/// because the coat's albedo is known for one width alone: so nothing sends on more than it gets.
constexpr float kAnisotropicLoss = 0.15f;

/// The index of refraction of the dielectric whose curve a coat or a metal follows that adds to the
/// base, at most: one of 3.7 and above reflects least somewhere between normal and grazing
/// incidence.
constexpr float kMostCurveIndex = 3.5f;

/// The average albedo of a white diffuse lobe of Burley's model by its roughness,
/// docs/light_transport.md (13).
float average_burley_albedo(float roughness)
{
    return 0.952948f + (0.108702f + 0.003519f * roughness) * roughness;
}

/// An anisotropic reflection is no mirror's, nor is that of a coat that may have a normal of its
/// own: across it is at least so rough.
constexpr float kLeastSpreadRoughness = 0.03f;

/// The largest exponent of Lafortune's model: a lobe about any axis is no mirror's, but at least
/// about kLeastSpreadRoughness rough.
constexpr float kMostLafortuneExponent = 600000;

/// A material of glTF's metallic-roughness model at a point.
struct MetallicRoughness {
    const Material& material;
    const MaterialPoint& at;
    float roughness;     ///< of its reflection
    Facets facets;       ///< of reflection and glass; alpha 0: smooth
    float opaque;        ///< share that is neither metal nor glass
    float glass;         ///< share that is a dielectric that transmits
    Reflectance fresnel; ///< of the coat over the diffuse lobe and of metal, by their shares

    bool has_reflection() const { return !fresnel.is_zero(); }
};

/// The index of refraction of a dielectric with this reflectance at normal incidence.
float index_of_reflectance(float f0)
{
    const float root = std::sqrt(f0);
    return std::min((1 + root) / (1 - std::min(root, 0.99f)), kMostCurveIndex);
}

/// Reflectance of the dielectric over a diffuse lobe, docs/light_transport.md (2), (38).
Reflectance coat_reflectance(const Material& material, const MaterialPoint& at)
{
    const Rgb f0 =
        glm::min(reflectance_of_index(material.ior) * at.specular_color, Rgb(1)) * at.specular;
    const float most = max_channel(f0);
    if (!material.coat_adds)
        return {f0, Rgb(at.specular * std::min(1.0f, most / kLeastReflectance))};
    if (!(most > 0))
        return {};
    return {f0, Rgb(1), index_of_reflectance(most)};
}

/// Blender before 4 has a quarter of what glTF means by the factor, on the curve of index 1.5.
Reflectance clear_coat_reflectance(const Material& material, float share)
{
    Reflectance out = clearcoat_fresnel(material.coat_adds ? share / 4 : share);
    if (material.coat_adds)
        out.index = 1.5f;
    return out;
}

Layers layers_of(const MetallicRoughness& of)
{
    const MaterialPoint& at = of.at;
    Layers out;
    const Reflectance coat = coat_reflectance(of.material, at);
    out.adds = of.material.coat_adds;
    out.coated = of.opaque > 0 && !coat.is_zero();
    if (out.coated)
        out.coat = coat;
    out.coat_alpha = of.facets.alpha;
    if (at.transmission == 0) {
        out.sheen = max_channel(at.sheen_color);
        out.sheen_alpha = std::clamp(at.sheen_roughness, kLeastSheenAlpha, 1.0f);
        out.clearcoat = std::max(0.0f, at.clearcoat);
    }
    return out;
}

/// Returns the reflectance of the coat over the diffuse lobe and of metal, mixed by their shares.
/// Where coats add to the base, metal follows the Fresnel curve of the dielectric too.
Reflectance mixed_reflectance(const MetallicRoughness& of)
{
    const MaterialPoint& at = of.at;
    const Reflectance dielectric = coat_reflectance(of.material, at);
    const Reflectance coat = of.opaque > 0 ? dielectric : Reflectance{};
    Reflectance out{at.metallic * at.base_color + of.opaque * coat.f0,
                    at.metallic + of.opaque * coat.f90, dielectric.index};
    if (of.material.coat_adds && !(out.index > 0))
        out.f90 = out.f0;
    return out;
}

MetallicRoughness metallic_roughness(const Material& material, const MaterialPoint& at)
{
    MetallicRoughness out{.material = material,
                          .at = at,
                          .roughness = at.anisotropy > 0
                                           ? std::max(at.roughness, kLeastSpreadRoughness)
                                           : at.roughness,
                          .facets = {},
                          .opaque = (1 - at.metallic) * (1 - at.transmission),
                          .glass = (1 - at.metallic) * at.transmission,
                          .fresnel = {}};
    out.fresnel = mixed_reflectance(out);
    out.facets.alpha = alpha_of(out.roughness);
    if (at.anisotropy > 0 &&
        (out.has_reflection() || out.glass > 0)) // docs/light_transport.md (31)
        out.facets.alpha_along =
            out.facets.alpha + (1 - out.facets.alpha) * at.anisotropy * at.anisotropy;
    return out;
}

/// What reaches the base and is not lost below the coat, by which the base colour is multiplied,
/// docs/light_transport.md (1), (31).
Rgb share_of_base(const MetallicRoughness& of, const Layers& layers)
{
    float kept = 1;
    if (of.facets.alpha_along > 0)
        kept -= kAnisotropicLoss * (of.facets.alpha_along - of.facets.alpha);
    return kept * of.opaque / glm::max(layers.diffuse_average, Rgb(1e-6f));
}

/// The base colour, scaled down where base and coats would send on more light than they receive,
/// docs/light_transport.md (38).
Rgb bounded_base(const MetallicRoughness& of, const Layers& layers)
{
    const MaterialPoint& at = of.at;
    if (!layers.adds)
        return at.base_color;
    Rgb left(1);
    if (layers.coated)
        left -= average_reflection_albedo(layers.coat, layers.coat_alpha);
    if (layers.clearcoat > 0)
        left -= average_reflection_albedo(clear_coat_reflectance(of.material, layers.clearcoat),
                                          layers.clearcoat_alpha);
    if (of.material.diffuse_model == DiffuseModel::burley)
        left /= average_burley_albedo(at.roughness);
    return glm::min(at.base_color, left);
}

PlacedLobe diffuse_lobe(DiffuseModel model, const Rgb& reflectance, float roughness)
{
    const auto placed = [](const Lobe& lobe) {
        return PlacedLobe(lobe, Depth::diffuse, Lobes::gathered);
    };
    switch (model) {
    case DiffuseModel::burley:
        return placed(Burley{reflectance, {roughness}});
    case DiffuseModel::oren_nayar:
        return placed(OrenNayar{reflectance, {roughness}});
    case DiffuseModel::lambert:
        break;
    }
    return placed(Lambert{reflectance});
}

/// docs/light_transport.md (1): the diffuse base and what passes it.
void add_diffuse(const MetallicRoughness& of, Bsdf& out)
{
    const MaterialPoint& at = of.at;
    const Rgb below = share_of_base(of, out.layers);
    const float passed = at.transmission == 0 ? std::max(0.0f, at.diffuse_transmission) : 0.0f;
    out.diffuse = below * bounded_base(of, out.layers) * (1 - passed);
    if (!is_black(out.diffuse))
        add(diffuse_lobe(of.material.diffuse_model, out.diffuse, at.roughness), out);
    out.diffuse_transmitted = below * passed * at.diffuse_transmission_color;
    if (!is_black(out.diffuse_transmitted))
        add({DiffuseTransmission{out.diffuse_transmitted}, Depth::diffuse, Lobes::gathered}, out);
}

void add_reflection(const MetallicRoughness& of, Bsdf& out)
{
    if (!of.has_reflection())
        return;
    const Lobes handled = handled_at(of.roughness);
    if (handled == Lobes::specular) {
        add({SmoothMirror{of.fresnel}, Depth::reflection, handled}, out);
        return;
    }
    MicrofacetReflection lobe{of.fresnel, of.facets};
    if (of.material.energy_compensation)
        lobe.multiple = multiple_factor(of.at.base_color, of.facets.alpha) * of.at.metallic;
    add({lobe, Depth::reflection, handled}, out);
}

void add_glass(const MetallicRoughness& of, Bsdf& out)
{
    if (!(of.glass > 0))
        return;
    const Rgb reflection = glm::min(of.at.specular_color, Rgb(1)) * of.at.specular;
    out.dispersion = of.material.dispersion;
    out.rough_glass = of.facets.alpha > 0;
    const Rgb tint = of.material.tint_by_root ? glm::sqrt(of.at.base_color) : of.at.base_color;
    if (out.rough_glass)
        add({RoughDielectric{of.glass, tint, reflection, of.facets}, Depth::reflection,
             Lobes::followed},
            out);
    else
        add({SmoothDielectric{of.glass, tint, reflection}, Depth::reflection, Lobes::specular},
            out);
}

float clearcoat_roughness(const Material& material, const MaterialPoint& at)
{
    return tilts(material) ? std::max(at.clearcoat_roughness, kLeastSpreadRoughness)
                           : at.clearcoat_roughness;
}

void add_clearcoat(const MetallicRoughness& of, Bsdf& out)
{
    if (!(out.layers.clearcoat > 0))
        return;
    const Lobes handled = handled_at(clearcoat_roughness(of.material, of.at));
    const Reflectance fresnel = clear_coat_reflectance(of.material, out.layers.clearcoat);
    if (handled == Lobes::specular)
        add({SmoothMirror{fresnel}, Depth::clearcoat, handled}, out);
    else
        add({MicrofacetReflection{fresnel, {out.layers.clearcoat_alpha}}, Depth::clearcoat,
             handled},
            out);
}

void make_metallic_roughness(const Material& material, const MaterialPoint& at, Bsdf& out)
{
    const MetallicRoughness of = metallic_roughness(material, at);
    out.layers = layers_of(of);
    if (out.layers.clearcoat > 0)
        out.layers.clearcoat_alpha = alpha_of(clearcoat_roughness(material, at));
    finish(out.layers);
    out.ior = of.facets.alpha > 0 ? std::max(material.ior, kLeastRoughIndex) : material.ior;
    add_diffuse(of, out);
    add_reflection(of, out);
    add_glass(of, out);
    if (out.layers.sheen > 0)
        add({Sheen{at.sheen_color, out.layers.sheen_alpha}, Depth::sheen, Lobes::gathered}, out);
    add_clearcoat(of, out);
}

/// Adds the diffuse base below a lobe of the material's specular colour: what that leaves.
void add_base_below_lobe(const Material& material, const MaterialPoint& at, Bsdf& out)
{
    out.diffuse = at.base_color * (1.0f - material.lobe_specular);
    if (!is_black(out.diffuse))
        add({Lambert{out.diffuse}, Depth::diffuse, Lobes::gathered}, out);
}

/// docs/light_transport.md (35).
void make_phong(const Material& material, const MaterialPoint& at, Bsdf& out)
{
    add_base_below_lobe(material, at, out);
    if (is_black(material.lobe_specular))
        return;
    const Lobes handled = handled_at(cosine_power_roughness(material.lobe_exponent));
    if (handled == Lobes::specular)
        add({PhongMirror{material.lobe_specular}, Depth::reflection, handled}, out);
    else
        add({Phong{material.lobe_specular, material.lobe_exponent}, Depth::reflection, handled},
            out);
}

/// docs/light_transport.md (45).
void make_ward(const Material& material, const MaterialPoint& at, Bsdf& out)
{
    add_base_below_lobe(material, at, out);
    const Rgb& specular = material.lobe_specular;
    if (is_black(specular))
        return;
    const glm::vec2& slopes = material.ward_slopes;
    if (alpha_of(std::sqrt(std::max(slopes.x, slopes.y))) == 0) {
        add({SmoothMirror{{specular, specular}}, Depth::reflection, Lobes::specular}, out);
        return;
    }
    const glm::vec2 spread = glm::max(slopes, kLeastSpreadRoughness * kLeastSpreadRoughness);
    add({Ward{specular, spread}, Depth::reflection,
         handled_at(std::sqrt(std::min(spread.x, spread.y)))},
        out);
}

/// docs/light_transport.md (46).
void make_lafortune(const Material& material, const MaterialPoint& at, Bsdf& out)
{
    add_base_below_lobe(material, at, out);
    if (is_black(material.lobe_specular))
        return;
    const float exponent = std::min(material.lobe_exponent, kMostLafortuneExponent);
    add({Lafortune{material.lobe_specular, exponent, material.lafortune_coefficients},
         Depth::reflection, handled_at(cosine_power_roughness(exponent))},
        out);
}

/// docs/light_transport.md (36).
void make_schlick(const Material& material, const MaterialPoint& at, Bsdf& out)
{
    const float roughness = std::sqrt(std::sqrt(at.roughness));
    const float alpha = alpha_of(roughness);
    const SchlickShares shares = schlick_shares(alpha * alpha);
    out.diffuse = shares.even * at.base_color;
    if (!is_black(out.diffuse))
        add({Lambert{out.diffuse}, Depth::diffuse, Lobes::gathered}, out);
    const Reflectance fresnel{at.base_color, Rgb(1)};
    if (alpha > 0)
        add({Schlick{fresnel, alpha, std::clamp(material.isotropy, kLeastIsotropy, 1.0f)},
             Depth::reflection, handled_at(roughness)},
            out);
    if (shares.mirror > 0)
        add({SmoothMirror{{shares.mirror * fresnel.f0, shares.mirror * fresnel.f90}},
             Depth::reflection, Lobes::specular},
            out);
}

bool is_diffuse_alone(const Bsdf& bsdf)
{
    const std::size_t diffuse = is_black(bsdf.diffuse) ? 0 : 1;
    return bsdf.count == diffuse && !bsdf.layers.any;
}

} // namespace

Bsdf make_bsdf(const Material& material, const MaterialPoint& at)
{
    Bsdf out;
    if (!material.boundary)
        return out; // no surface
    out.absorption = material.absorption;
    out.emission = at.emission;
    out.emits_behind = material.double_sided;
    switch (material.reflection_model) {
    case ReflectionModel::metallic_roughness:
        make_metallic_roughness(material, at, out);
        break;
    case ReflectionModel::phong:
        make_phong(material, at, out);
        break;
    case ReflectionModel::schlick:
        make_schlick(material, at, out);
        break;
    case ReflectionModel::ward:
        make_ward(material, at, out);
        break;
    case ReflectionModel::lafortune:
        make_lafortune(material, at, out);
        break;
    }
    out.is_diffuse = is_diffuse_alone(out);
    return out;
}

std::vector<Bsdf> make_bsdfs(const std::vector<Material>& materials)
{
    std::vector<Bsdf> out;
    out.reserve(materials.size());
    for (const Material& material : materials)
        out.push_back(make_bsdf(material, material_factors(material)));
    return out;
}

} // namespace hipmap
