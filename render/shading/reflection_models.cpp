#include "render/shading/reflection_models.h"

#include "common/math/frame.h"
#include "common/math/sampling.h"
#include "render/shading/ggx.h"
#include "render/shading/glossy_albedo.h"
#include "render/shading/phong.h"
#include "render/shading/schlick_layer.h"

namespace hipmap {

namespace {

bool is_phong(const Bsdf& bsdf)
{
    return bsdf.model == ReflectionModel::phong;
}

void make_phong(const Material& material, const MaterialPoint& at, Bsdf& out)
{
    const float roughness = phong_roughness(material.phong_exponent);
    out.alpha = alpha_of(roughness);
    out.exponent = material.phong_exponent;
    out.diffuse = at.base_color * (1.0f - material.phong_specular);
    out.reflect_f0 = material.phong_specular;
    if (!is_black(material.phong_specular))
        out.reflection = kind_of(roughness);
}

void make_schlick(const Material& material, const MaterialPoint& at, Bsdf& out)
{
    const float roughness = std::sqrt(std::sqrt(at.roughness));
    out.alpha = alpha_of(roughness);
    out.isotropy = std::clamp(material.isotropy, kLeastIsotropy, 1.0f);
    const SchlickShares shares = schlick_shares(out.alpha * out.alpha);
    out.diffuse = shares.even * at.base_color;
    out.mirror_share = shares.mirror;
    out.reflect_f0 = at.base_color;
    out.reflect_f90 = Rgb(1);
    out.reflection = kind_of(roughness);
}

SchlickShares shares_of(const Bsdf& bsdf)
{
    return schlick_shares(bsdf.alpha * bsdf.alpha);
}

} // namespace

void make_modelled(const Material& material, const MaterialPoint& at, Bsdf& out)
{
    out.model = material.reflection_model;
    if (is_phong(out))
        make_phong(material, at, out);
    else
        make_schlick(material, at, out);
    out.only_diffuse = out.reflection == Reflection::none;
}

Rgb modelled_lobe(const Bsdf& bsdf, const glm::vec3& normal, const glm::vec3& in,
                  const glm::vec3& out)
{
    if (is_phong(bsdf))
        return bsdf.reflect_f0 * phong_lobe(in, reflect(out, normal), bsdf.exponent);
    const SchlickShares shares = shares_of(bsdf);
    const glm::vec3 half = glm::normalize(in + out);
    const Rgb reflected = opaque_reflectance(bsdf, glm::dot(half, out));
    const SchlickLayer layer{normal, bsdf.along, bsdf.alpha, bsdf.isotropy};
    // The diffuse lobe has the part of what is even that is the same for all directions.
    return reflected * (shares.spread * layer.spread(in, out, half)) +
           (reflected - bsdf.reflect_f0) * (shares.even / kPi);
}

float modelled_density(const Bsdf& bsdf, const glm::vec3& normal, const glm::vec3& in,
                       const glm::vec3& out)
{
    if (is_phong(bsdf))
        return phong_density(in, reflect(out, normal), bsdf.exponent);
    const float even = shares_of(bsdf).even;
    const glm::vec3 half = glm::normalize(in + out);
    return even * glm::dot(in, normal) / kPi +
           (1 - even) * reflected_density(normal, out, half, bsdf.alpha);
}

glm::vec3 draw_modelled(const Bsdf& bsdf, const glm::vec3& normal, const glm::vec3& out,
                        RandomSequence& random)
{
    const glm::vec2 u = random.next2();
    if (is_phong(bsdf))
        return draw_phong(reflect(out, normal), bsdf.exponent, u);
    const float even = shares_of(bsdf).even;
    if (even > 0 && random.next() < even)
        return Frame(normal).to_world(sample_cosine_hemisphere(u));
    return reflect(out, sample_facet(normal, out, bsdf.alpha, u));
}

Rgb modelled_albedo(const Bsdf& bsdf, float cosine)
{
    if (bsdf.alpha == 0)
        return modelled_mirror(bsdf, cosine);
    if (is_phong(bsdf))
        return bsdf.reflect_f0 * phong_albedo(cosine, bsdf.exponent);
    const SchlickShares shares = shares_of(bsdf);
    return shares.spread * glossy_albedo(cosine, bsdf.alpha).of(bsdf.reflect_f0, bsdf.reflect_f90) +
           shares.even / 21 * (1.0f - bsdf.reflect_f0);
}

Rgb modelled_mirror(const Bsdf& bsdf, float cosine)
{
    if (is_phong(bsdf))
        return bsdf.alpha > 0 ? Rgb(0) : bsdf.reflect_f0 * cosine;
    return bsdf.mirror_share * opaque_reflectance(bsdf, cosine);
}

} // namespace hipmap
