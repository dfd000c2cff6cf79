#include "render/shading/gathered_lobes.h"

#include "render/shading/energy_compensation.h"
#include "render/shading/facets.h"
#include "render/shading/reflection_models.h"
#include "render/shading/sheen.h"

namespace hipmap {

void GatheredLobes::see_through_coats()
{
    const float cosine = std::max(0.0f, glm::dot(normal_, out_));
    const Rgb seen = through_coats(bsdf_, incidence(bsdf_, out_, cosine));
    base_ *= seen;
    beyond_ = bsdf_.diffuse_beyond / kPi * seen;
}

Rgb GatheredLobes::passed(const glm::vec3& in, float cosine) const
{
    return cosine > 0 && glm::dot(geometric_, in) < 0
               ? beyond_ * through_coats(bsdf_, incidence(bsdf_, -in, cosine))
               : Rgb(0);
}

Rgb GatheredLobes::of_all(const glm::vec3& in, float cosine) const
{
    Rgb value = diffuse(in, cosine);
    if (bsdf_.is_matt())
        return value;
    if (bsdf_.reflection == Reflection::gathered)
        value += facets(bsdf_, normal_, in, cosine);
    if (bsdf_.clearcoat == Reflection::gathered)
        value += facets(clearcoat_alone(bsdf_),
                        bsdf_.coat_agreement < 1 ? bsdf_.coat_normal : normal_, in, cosine);
    if (bsdf_.has_sheen())
        value += scattered_by_sheen(bsdf_, normal_, in, out_);
    return value;
}

Rgb GatheredLobes::facets(const Bsdf& bsdf, const glm::vec3& normal, const glm::vec3& in,
                          float cosine) const
{
    const float above = glm::dot(normal, in);
    Rgb value(0.0f);
    if (above > 0)
        value = reflected_by_facets(bsdf, normal, in, out_) * (above / cosine);
    // A photon of a face beside may come from below this one: nothing is folded to there.
    if (normal != geometric_ && glm::dot(geometric_, in) > 0) {
        const glm::vec3 below = mirrored(in, geometric_);
        const float folded = glm::dot(normal, below);
        if (folded > 0)
            value += reflected_by_facets(bsdf, normal, below, out_) * (folded / cosine);
    }
    return value;
}

Rgb scattered_by_sheen(const Bsdf& bsdf, const glm::vec3& normal, const glm::vec3& in,
                       const glm::vec3& out)
{
    const float cos_in = glm::dot(normal, in), cos_out = glm::dot(normal, out);
    const glm::vec3 both = in + out;
    const float along = cos_in + cos_out;
    const float sin2_half = 1 - along * along / glm::dot(both, both);
    return bsdf.sheen *
           (sheen_lobe(cos_in, cos_out, sin2_half, bsdf.sheen_alpha) *
            through_clearcoat(bsdf, incidence(bsdf, in, cos_in), incidence(bsdf, out, cos_out)));
}

Rgb reflected_by_facets(const Bsdf& bsdf, const glm::vec3& normal, const glm::vec3& in,
                        const glm::vec3& out)
{
    if (bsdf.is_modelled()) [[unlikely]]
        return modelled_lobe(bsdf, normal, in, out);
    const glm::vec3 half = glm::normalize(in + out);
    const float cos_in = glm::dot(normal, in), cos_out = glm::dot(normal, out);
    const float passed =
        through_layers(bsdf, incidence(bsdf, in, cos_in), incidence(bsdf, out, cos_out));
    const Rgb single = opaque_reflectance(bsdf, glm::dot(half, out)) *
                       (facet_spread(bsdf, normal, in, out, half) * passed);
    return bsdf.is_compensated() ? single + regained_lobe(bsdf, cos_in, cos_out) * passed : single;
}

} // namespace hipmap
