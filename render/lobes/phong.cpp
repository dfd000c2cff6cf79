#include "render/lobes/phong.h"

#include "common/math/frame.h"
#include "common/math/sampling.h"
#include "render/lobes/fresnel.h"

#include <algorithm>
#include <cmath>

namespace hipmap {

namespace {

/// Power of the cosine of the angle between two unit directions; 0 beyond a right angle.
float cosine_power(const glm::vec3& a, const glm::vec3& b, float exponent)
{
    if (!(glm::dot(a, b) > 0))
        return 0;
    // By the sine: the cosine has no digits left in narrow lobes.
    const glm::vec3 across = glm::cross(a, b);
    const float sin2 = std::min(glm::dot(across, across), 1.0f);
    return exponent > 0 ? std::exp(0.5f * exponent * std::log1p(-sin2)) : 1.0f;
}

/// Drawn about a unit axis.  u: [0, 1)^2.
glm::vec3 sample_power(const glm::vec3& axis, float exponent, const glm::vec2& u)
{
    const float log_cosine = std::log1p(-u.x) / (exponent + 1);
    const float sine = std::sqrt(-std::expm1(2 * log_cosine));
    const float turn = 2 * kPi * u.y;
    return Frame(axis).to_world(
        {sine * std::cos(turn), sine * std::sin(turn), std::exp(log_cosine)});
}

} // namespace

float phong_roughness(float exponent)
{
    return std::pow(2 * exponent + 1, -0.25f);
}

Rgb Phong::eval(const LobeView& view, const glm::vec3& in) const
{
    const float power = cosine_power(in, reflect(view.out, view.normal), exponent);
    return factor * ((exponent + 2) / (2 * kPi) * power);
}

float Phong::pdf(const LobeView& view, const glm::vec3& in) const
{
    return (exponent + 1) / (2 * kPi) * cosine_power(in, reflect(view.out, view.normal), exponent);
}

LobeSample Phong::sample(const LobeView& view, RandomSequence& random) const
{
    LobeSample out;
    out.direction = sample_power(reflect(view.out, view.normal), exponent, random.next2());
    const float cosine = glm::dot(out.direction, view.normal);
    if (cosine > 0)
        out.weight = factor * (cosine * (exponent + 2) / (exponent + 1));
    return out;
}

Rgb Phong::albedo(const LobeView& view) const
{
    const float cosine = view.cosine;
    return factor * (cosine + (1 - cosine) * 0.5f / std::sqrt(1 + 0.5f * kPi * exponent));
}

} // namespace hipmap
