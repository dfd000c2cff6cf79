#include "render/lobes/fresnel.h"

#include <algorithm>
#include <cmath>

namespace hipmap {

float fresnel_dielectric(float cosine, float eta)
{
    const float sin2_behind = (1 - cosine * cosine) / (eta * eta);
    if (sin2_behind >= 1)
        return 1;
    const float cos_behind = std::sqrt(1 - sin2_behind);
    const float parallel = (eta * cosine - cos_behind) / (eta * cosine + cos_behind);
    const float perpendicular = (cosine - eta * cos_behind) / (cosine + eta * cos_behind);
    return 0.5f * (parallel * parallel + perpendicular * perpendicular);
}

float average_dielectric_weight(float index)
{
    constexpr double kSame = 1e-4; // nearer to 1 the terms cancel to less than their rounding
    const double n = index, n2 = n * n, n4 = n2 * n2;
    if (!(n - 1 > kSame))
        return 0;
    const double average =
        0.5 + (n - 1) * (3 * n + 1) / (6 * (n + 1) * (n + 1)) +
        n2 * (n2 - 1) * (n2 - 1) / std::pow(n2 + 1, 3) * std::log((n - 1) / (n + 1)) -
        2 * n2 * n * (n2 + 2 * n - 1) / ((n2 + 1) * (n4 - 1)) +
        8 * n4 * (n4 + 1) / ((n2 + 1) * (n4 - 1) * (n4 - 1)) * std::log(n);
    const double least = reflectance_of_index(index);
    return static_cast<float>((average - least) / (1 - least));
}

Rgb scaled_fresnel(float cosine, float eta, const Rgb& scale)
{
    const float f = fresnel_dielectric(cosine, eta);
    return f < 1 ? f * scale : Rgb(1);
}

glm::vec3 refract(const glm::vec3& direction, const glm::vec3& normal, float eta)
{
    const float cosine = glm::dot(direction, normal);
    const float cos2_behind = 1 - (1 - cosine * cosine) / (eta * eta);
    const float cos_behind = std::sqrt(std::max(0.0f, cos2_behind));
    return glm::normalize((normal * cosine - direction) / eta - normal * cos_behind);
}

glm::vec3 reflect(const glm::vec3& direction, const glm::vec3& normal)
{
    return glm::normalize(2 * glm::dot(direction, normal) * normal - direction);
}

} // namespace hipmap
