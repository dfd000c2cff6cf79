#include "render/shading/phong.h"

#include "common/math/frame.h"
#include "common/math/sampling.h"

namespace hipmap {

namespace {

/// A power of the cosine of the angle between two directions; 0 beyond a right angle.
float cosine_power(const glm::vec3& a, const glm::vec3& b, float exponent)
{
    if (!(glm::dot(a, b) > 0))
        return 0;
    // By the sine: the cosine has no digits left in narrow lobes.
    const glm::vec3 across = glm::cross(a, b);
    const float sin2 = std::min(glm::dot(across, across), 1.0f);
    return exponent > 0 ? std::exp(0.5f * exponent * std::log1p(-sin2)) : 1.0f;
}

} // namespace

float phong_roughness(float exponent)
{
    return std::pow(2 * exponent + 1, -0.25f);
}

float phong_lobe(const glm::vec3& in, const glm::vec3& image, float exponent)
{
    return (exponent + 2) / (2 * kPi) * cosine_power(in, image, exponent);
}

float phong_density(const glm::vec3& in, const glm::vec3& image, float exponent)
{
    return (exponent + 1) / (2 * kPi) * cosine_power(in, image, exponent);
}

glm::vec3 draw_phong(const glm::vec3& image, float exponent, const glm::vec2& u)
{
    const float log_cosine = std::log1p(-u.x) / (exponent + 1);
    const float sine = std::sqrt(-std::expm1(2 * log_cosine));
    const float turn = 2 * kPi * u.y;
    return Frame(image).to_world(
        {sine * std::cos(turn), sine * std::sin(turn), std::exp(log_cosine)});
}

float phong_albedo(float cosine, float exponent)
{
    return cosine + (1 - cosine) * 0.5f / std::sqrt(1 + 0.5f * kPi * exponent);
}

} // namespace hipmap
