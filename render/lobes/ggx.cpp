#include "render/lobes/ggx.h"

#include "common/math/frame.h"
#include "common/math/sampling.h"

namespace hipmap {

float ggx_slope(float cosine, float alpha)
{
    const float alpha2 = alpha * alpha;
    return std::sqrt(alpha2 + (1 - alpha2) * cosine * cosine);
}

float ggx_distribution(const glm::vec3& normal, const glm::vec3& half, float alpha)
{
    // The sine by the cross product: one minus the squared cosine has no digits left in narrow
    // lobes.
    const glm::vec3 across = glm::cross(normal, half);
    const float cosine = glm::dot(normal, half);
    const float spread = glm::dot(across, across) + alpha * alpha * cosine * cosine;
    return cosine > 0 ? alpha * alpha / (kPi * spread * spread) : 0;
}

float ggx_visibility(float cos_in, float cos_out, float alpha)
{
    return 0.5f / (cos_out * ggx_slope(cos_in, alpha) + cos_in * ggx_slope(cos_out, alpha));
}

float ggx_shadowing(float cos_in, float cos_out, float alpha)
{
    const float slope = ggx_slope(cos_out, alpha);
    return cos_in * (cos_out + slope) / (cos_out * ggx_slope(cos_in, alpha) + cos_in * slope);
}

float ggx_reflected_pdf(const glm::vec3& normal, const glm::vec3& out, const glm::vec3& half,
                        float alpha)
{
    const float cosine = glm::dot(normal, out);
    return 0.5f * ggx_distribution(normal, half, alpha) / (cosine + ggx_slope(cosine, alpha));
}

float ggx_facet_pdf(const glm::vec3& normal, const glm::vec3& out, const glm::vec3& half,
                    float alpha)
{
    const float visible = glm::dot(out, half);
    return visible > 0 ? 4 * visible * ggx_reflected_pdf(normal, out, half, alpha) : 0;
}

glm::vec3 sample_facet(const glm::vec3& normal, const glm::vec3& out, float alpha,
                       const glm::vec2& u)
{
    const Frame frame(normal);
    const glm::vec3 local = frame.to_local(out);
    // Stretched so that the facets become a hemisphere, of which a cap reflects upwards.
    const glm::vec3 from = glm::normalize(glm::vec3(alpha * local.x, alpha * local.y, local.z));
    const glm::vec3 cap = direction_from_cosine(1 - u.x * (1 + from.z), u.y);
    const glm::vec3 half = cap + from;
    return frame.to_world(
        glm::normalize(glm::vec3(alpha * half.x, alpha * half.y, std::max(half.z, 1e-6f * alpha))));
}

} // namespace hipmap
