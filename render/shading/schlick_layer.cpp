#include "render/shading/schlick_layer.h"

#include "render/shading/ggx.h"

#include <glm/glm.hpp>

#include <cmath>

namespace hipmap {

SchlickShares schlick_shares(float roughness)
{
    SchlickShares out;
    out.spread = 4 * roughness * (1 - roughness);
    (roughness < 0.5f ? out.mirror : out.even) = 1 - out.spread;
    return out;
}

namespace {

/// A(w): more light where the half vector leans along `along` than across it.
float azimuth_factor(const SchlickLayer& layer, const glm::vec3& half)
{
    const float x = glm::dot(half, glm::cross(layer.normal, layer.along));
    const float y = glm::dot(half, layer.along);
    const float p = layer.isotropy, sine2 = x * x + y * y;
    return sine2 > 0 ? std::sqrt(p * sine2 / (p * p * y * y + x * x)) : 1;
}

} // namespace

float SchlickLayer::spread(const glm::vec3& in, const glm::vec3& out, const glm::vec3& half) const
{
    // G(c)/c, of which the cosines cancel.
    const auto masking = [k = 0.5f * alpha](float cosine) { return k * (1 - cosine) + cosine; };
    const float visibility =
        0.25f / (masking(glm::dot(in, normal)) * masking(glm::dot(out, normal)));
    const float turned = isotropy < 1 ? azimuth_factor(*this, half) : 1;
    return ggx_distribution(normal, half, alpha) * visibility * turned; // Z/pi is theirs
}

} // namespace hipmap
