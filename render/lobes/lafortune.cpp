#include "render/lobes/lafortune.h"

#include "common/math/sampling.h"
#include "render/lobes/cosine_power.h"

#include <algorithm>
#include <cmath>

namespace hipmap {

namespace {

/// What the coefficients make of a direction: C w in docs/light_transport.md (46).
struct Axis {
    glm::vec3 direction{0.0f}; ///< unit
    float power = 0.0f;        ///< its length to the power of the exponent; 0: there is no lobe
};

Axis axis_of(const Lafortune& lobe, const LobeView& view)
{
    const glm::vec3& c = lobe.coefficients;
    const glm::vec3 up = view.cosine * view.normal, flat = view.out - up;
    const float mean = 0.5f * (c.x + c.y);
    glm::vec3 turned = mean * flat + c.z * up;
    // What is missing from a length of 1, which has digits left where that is near.
    float missing = (1 - mean * mean) * glm::dot(flat, flat);
    if (view.has_tangent() && lobe.is_directed()) {
        const glm::vec3 across = glm::cross(view.normal, view.tangent);
        const float x = glm::dot(flat, view.tangent), y = glm::dot(flat, across);
        turned = c.x * x * view.tangent + c.y * y * across + c.z * up;
        missing = (1 - c.x * c.x) * x * x + (1 - c.y * c.y) * y * y;
    }
    missing += (1 - c.z * c.z) * view.cosine * view.cosine;
    const float square = glm::dot(turned, turned);
    if (!(square > 0) || !(missing < 1))
        return {};
    return {turned / std::sqrt(square), std::exp(0.5f * lobe.exponent * std::log1p(-missing))};
}

} // namespace

Rgb Lafortune::eval(const LobeView& view, const glm::vec3& in) const
{
    const Axis axis = axis_of(*this, view);
    if (!(axis.power > 0))
        return Rgb(0);
    const float power = axis.power * cosine_power(in, axis.direction, exponent);
    return factor * ((exponent + 2) / (2 * kPi) * power);
}

float Lafortune::pdf(const LobeView& view, const glm::vec3& in) const
{
    const Axis axis = axis_of(*this, view);
    if (!(axis.power > 0))
        return 0;
    return (exponent + 1) / (2 * kPi) * cosine_power(in, axis.direction, exponent);
}

LobeSample Lafortune::sample(const LobeView& view, RandomSequence& random) const
{
    const Axis axis = axis_of(*this, view);
    LobeSample out;
    const glm::vec2 u = random.next2();
    if (!(axis.power > 0))
        return out;
    out.direction = sample_cosine_power(axis.direction, exponent, u);
    const float cosine = glm::dot(out.direction, view.normal);
    if (cosine > 0)
        out.weight = factor * (axis.power * cosine * (exponent + 2) / (exponent + 1));
    return out;
}

Rgb Lafortune::albedo(const LobeView& view) const
{
    const Axis axis = axis_of(*this, view);
    const float cosine = std::clamp(glm::dot(axis.direction, view.normal), 0.0f, 1.0f);
    const float beside = (1 - cosine) * 0.5f / std::sqrt(1 + 0.5f * kPi * exponent);
    return factor * (axis.power * (cosine + beside));
}

} // namespace hipmap
