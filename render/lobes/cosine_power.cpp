#include "render/lobes/cosine_power.h"

#include "common/math/frame.h"
#include "common/math/sampling.h"

#include <algorithm>
#include <cmath>

namespace hipmap {

float cosine_power(const glm::vec3& a, const glm::vec3& b, float exponent)
{
    if (!(glm::dot(a, b) > 0))
        return 0;
    // By the sine: the cosine has no digits left in narrow lobes.
    const glm::vec3 across = glm::cross(a, b);
    const float sin2 = std::min(glm::dot(across, across), 1.0f);
    return exponent > 0 ? std::exp(0.5f * exponent * std::log1p(-sin2)) : 1.0f;
}

glm::vec3 sample_cosine_power(const glm::vec3& axis, float exponent, const glm::vec2& u)
{
    const float log_cosine = std::log1p(-u.x) / (exponent + 1);
    const float sine = std::sqrt(-std::expm1(2 * log_cosine));
    const float turn = 2 * kPi * u.y;
    return Frame(axis).to_world(
        {sine * std::cos(turn), sine * std::sin(turn), std::exp(log_cosine)});
}

float cosine_power_roughness(float exponent)
{
    return std::pow(2 * exponent + 1, -0.25f);
}

} // namespace hipmap
