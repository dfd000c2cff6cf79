#include "render/lobes/anisotropic_facets.h"

#include "common/math/sampling.h"

namespace hipmap {

float AnisotropicFacets::slope(const glm::vec3& direction) const
{
    const float x = alpha_along * glm::dot(direction, along);
    const float y = alpha_across * glm::dot(direction, across);
    const float z = glm::dot(direction, normal);
    return std::sqrt(x * x + y * y + z * z);
}

float AnisotropicFacets::distribution(const glm::vec3& half) const
{
    const float z = glm::dot(half, normal);
    if (!(z > 0))
        return 0;
    const float x = glm::dot(half, along) / alpha_along;
    const float y = glm::dot(half, across) / alpha_across;
    const float spread = x * x + y * y + z * z;
    return 1 / (kPi * alpha_along * alpha_across * spread * spread);
}

float AnisotropicFacets::spread(const glm::vec3& in, const glm::vec3& out,
                                const glm::vec3& half) const
{
    const float visibility =
        0.5f / (glm::dot(out, normal) * slope(in) + glm::dot(in, normal) * slope(out));
    return distribution(half) * visibility;
}

float AnisotropicFacets::shadowing(const glm::vec3& in, float cos_in, const glm::vec3& out,
                                   float cos_out) const
{
    const float slope_out = slope(out);
    return cos_in * (cos_out + slope_out) / (cos_out * slope(in) + cos_in * slope_out);
}

float AnisotropicFacets::reflected_pdf(const glm::vec3& out, const glm::vec3& half) const
{
    return 0.5f * distribution(half) / (glm::dot(out, normal) + slope(out));
}

float AnisotropicFacets::pdf(const glm::vec3& out, const glm::vec3& half) const
{
    const float visible = glm::dot(out, half);
    return visible > 0 ? 4 * visible * reflected_pdf(out, half) : 0;
}

glm::vec3 AnisotropicFacets::sample(const glm::vec3& out, const glm::vec2& u) const
{
    // As `sample_facet`, with two widths.
    const glm::vec3 widths(alpha_along, alpha_across, 1);
    const glm::vec3 local(glm::dot(out, along), glm::dot(out, across), glm::dot(out, normal));
    const glm::vec3 from = glm::normalize(widths * local);
    const glm::vec3 cap = direction_from_cosine(1 - u.x * (1 + from.z), u.y);
    const glm::vec3 drawn = cap + from;
    const float z = std::max(drawn.z, 1e-6f * alpha_across);
    const glm::vec3 half = glm::normalize(widths * glm::vec3(drawn.x, drawn.y, z));
    return along * half.x + across * half.y + normal * half.z;
}

} // namespace hipmap
