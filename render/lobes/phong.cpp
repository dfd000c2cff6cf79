#include "render/lobes/phong.h"

#include "common/math/sampling.h"
#include "render/lobes/cosine_power.h"
#include "render/lobes/fresnel.h"

#include <cmath>

namespace hipmap {

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
    out.direction = sample_cosine_power(reflect(view.out, view.normal), exponent, random.next2());
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
