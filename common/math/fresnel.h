#pragma once

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>

namespace hipmap {

/// Returns (1 - cosine)^5, of a cosine clamped to [0, 1].
inline float grazing_weight(float cosine)
{
    const float m = std::clamp(1 - cosine, 0.0f, 1.0f);
    return m * m * m * m * m;
}

/// Returns the reflectance of a smooth interface between dielectrics for unpolarised light; 1 at
/// total reflection.  cosine: of incidence, [0, 1].  eta: index of refraction behind the interface
/// over that before it.
inline float fresnel_dielectric(float cosine, float eta)
{
    const float sin2_behind = (1 - cosine * cosine) / (eta * eta);
    if (sin2_behind >= 1)
        return 1;
    const float cos_behind = std::sqrt(1 - sin2_behind);
    const float parallel = (eta * cosine - cos_behind) / (eta * cosine + cos_behind);
    const float perpendicular = (cosine - eta * cos_behind) / (cosine + eta * cos_behind);
    return 0.5f * (parallel * parallel + perpendicular * perpendicular);
}

/// Returns the reflectance of such an interface at normal incidence.
inline float reflectance_of_index(float index)
{
    const float root = (index - 1) / (index + 1);
    return root * root;
}

/// Returns the refracted direction behind a smooth interface, away from it. direction: unit, away
/// from the surface on the side that light comes from.  normal: unit, on the same side.  eta: as in
/// `fresnel_dielectric`; there must be no total reflection.
inline glm::vec3 refract(const glm::vec3& direction, const glm::vec3& normal, float eta)
{
    const float cosine = glm::dot(direction, normal);
    const float cos2_behind = 1 - (1 - cosine * cosine) / (eta * eta);
    const float cos_behind = std::sqrt(std::max(0.0f, cos2_behind));
    return glm::normalize((normal * cosine - direction) / eta - normal * cos_behind);
}

/// Returns the mirror image of `direction` in the plane across `normal`: on its other side.
inline glm::vec3 mirrored(const glm::vec3& direction, const glm::vec3& normal)
{
    return direction - 2 * glm::dot(direction, normal) * normal;
}

/// Returns the mirror image of `direction` about `normal`; both unit and away from the surface.
inline glm::vec3 reflect(const glm::vec3& direction, const glm::vec3& normal)
{
    return glm::normalize(2 * glm::dot(direction, normal) * normal - direction);
}

} // namespace hipmap
