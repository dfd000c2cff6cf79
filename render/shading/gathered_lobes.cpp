#include "render/shading/gathered_lobes.h"

#include "common/math/sampling.h"
#include "render/shading/ggx.h"

namespace hipmap {

GatheredLobes::GatheredLobes(const Bsdf& bsdf, const glm::vec3& normal, const glm::vec3& out)
    : bsdf_(bsdf), normal_(normal), out_(out), cosine_(std::max(0.0f, glm::dot(normal, out))),
      base_(bsdf.diffuse * coat_half(bsdf, cosine_) / kPi)
{
}

Rgb GatheredLobes::operator()(const glm::vec3& in) const
{
    const float cos_in = glm::dot(normal_, in);
    if (!(cos_in > 0))
        return Rgb(0);
    Rgb value = base_ * coat_half(bsdf_, cos_in) * diffuse_shape(bsdf_, normal_, in, out_);
    if (bsdf_.reflection == Reflection::gathered)
        value += reflected_by_facets(bsdf_, normal_, in, out_);
    return value;
}

Rgb reflected_by_facets(const Bsdf& bsdf, const glm::vec3& normal, const glm::vec3& in,
                        const glm::vec3& out)
{
    const glm::vec3 half = glm::normalize(in + out);
    const float spread = ggx_distribution(normal, half, bsdf.alpha) *
                         ggx_visibility(glm::dot(normal, in), glm::dot(normal, out), bsdf.alpha);
    return opaque_reflectance(bsdf, glm::dot(half, out)) * spread;
}

} // namespace hipmap
