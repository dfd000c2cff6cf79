// The part of bsdf.h that is about smooth interfaces, docs/light_transport.md (4).

#include "render/shading/bsdf.h"

#include <cmath>

namespace hipmap {

float fresnel_dielectric(float cosine, float eta)
{
    const float sin2_beyond = (1 - cosine * cosine) / (eta * eta);
    if (sin2_beyond >= 1)
        return 1;
    const float cos_beyond = std::sqrt(1 - sin2_beyond);
    const float parallel = (eta * cosine - cos_beyond) / (eta * cosine + cos_beyond);
    const float perpendicular = (cosine - eta * cos_beyond) / (cosine + eta * cos_beyond);
    return 0.5f * (parallel * parallel + perpendicular * perpendicular);
}

float index_beyond(const Bsdf& bsdf, bool front, bool solid)
{
    return solid && !front ? 1 / bsdf.ior : bsdf.ior;
}

Rgb glass_reflectance(const Bsdf& bsdf, float cosine, float eta)
{
    const float f = fresnel_dielectric(cosine, eta);
    return f < 1 ? f * bsdf.glass_reflection : Rgb(1);
}

glm::vec3 refract(const glm::vec3& direction, const glm::vec3& normal, float eta)
{
    const float cosine = glm::dot(direction, normal);
    const float cos2_beyond = 1 - (1 - cosine * cosine) / (eta * eta);
    const float cos_beyond = std::sqrt(std::max(0.0f, cos2_beyond));
    return glm::normalize((normal * cosine - direction) / eta - normal * cos_beyond);
}

glm::vec3 reflect(const glm::vec3& direction, const glm::vec3& normal)
{
    return glm::normalize(2 * glm::dot(direction, normal) * normal - direction);
}

} // namespace hipmap
