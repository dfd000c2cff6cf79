#include "render/lights/spread.h"

#include "common/math/sampling.h"

#include <algorithm>
#include <cmath>

namespace hipmap {

Spread make_spread(double half_angle)
{
    if (half_angle >= double{kPi} / 2)
        return {};
    const double tangent = std::tan(half_angle);
    return {static_cast<float>(1 / tangent), static_cast<float>(tangent / (tangent - half_angle)),
            static_cast<float>(std::cos(half_angle))};
}

float radiance_share(const Spread& spread, float cosine)
{
    if (spread.per_tangent == 0)
        return 1;
    const float tangent = std::sqrt(std::max(0.0f, 1 - cosine * cosine)) / cosine;
    return spread.on_axis * std::max(0.0f, 1 - tangent * spread.per_tangent);
}

glm::vec3 sample_direction(const Spread& spread, RandomSequence& random)
{
    glm::vec2 u = random.next2();
    if (spread.per_tangent == 0)
        return sample_cosine_hemisphere(u);
    // Even in the cone, by the cosine; at least one in three is taken.
    const float sin2 = 1 - spread.cos_edge * spread.cos_edge;
    for (;; u = random.next2()) {
        const glm::vec3 direction = sample_cosine_hemisphere({u.x * sin2, u.y});
        if (random.next() * spread.on_axis < radiance_share(spread, direction.z))
            return direction;
    }
}

} // namespace hipmap
