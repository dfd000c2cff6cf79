#include "render/lobes/ward.h"

#include "common/math/frame.h"
#include "common/math/sampling.h"
#include "render/lobes/fresnel.h"

#include <cmath>

namespace hipmap {

namespace {

/// The slopes and the directions on the surface in which they are measured.
struct Facing {
    glm::vec3 along, across, normal;
    glm::vec2 slopes;
};

Facing facing_of(const Ward& lobe, const LobeView& view)
{
    if (view.has_tangent())
        return {view.tangent, glm::cross(view.normal, view.tangent), view.normal, lobe.slopes};
    const Frame any(view.normal);
    return {any.x, any.y, any.z, glm::vec2(mean_ward_slope(lobe.slopes))};
}

/// The pdf of the slope of a half vector, which need not be unit: per area of the plane of slopes.
float slope_pdf(const Facing& of, const glm::vec3& half)
{
    const float up = glm::dot(half, of.normal);
    const float x = glm::dot(half, of.along) / (of.slopes.x * up);
    const float y = glm::dot(half, of.across) / (of.slopes.y * up);
    return std::exp(-x * x - y * y) / (kPi * of.slopes.x * of.slopes.y);
}

} // namespace

float mean_ward_slope(const glm::vec2& slopes)
{
    return slopes.x == slopes.y ? slopes.x : std::sqrt(slopes.x * slopes.y);
}

Rgb Ward::eval(const LobeView& view, const glm::vec3& in) const
{
    const glm::vec3 half = in + view.out; // as long as it is
    const float up = glm::dot(half, view.normal);
    const float shape = glm::dot(half, half) / (up * up * up * up);
    return factor * (slope_pdf(facing_of(*this, view), half) * shape);
}

float Ward::pdf(const LobeView& view, const glm::vec3& in) const
{
    const glm::vec3 half = glm::normalize(in + view.out);
    const float up = glm::dot(half, view.normal);
    return slope_pdf(facing_of(*this, view), half) / (4 * glm::dot(half, view.out) * up * up * up);
}

LobeSample Ward::sample(const LobeView& view, RandomSequence& random) const
{
    const Facing of = facing_of(*this, view);
    const glm::vec2 u = random.next2();
    const float steep = std::sqrt(-std::log1p(-u.x)), turn = 2 * kPi * u.y;
    const glm::vec2 slope = of.slopes * steep * glm::vec2(std::cos(turn), std::sin(turn));
    const glm::vec3 half = of.along * slope.x + of.across * slope.y + of.normal;
    LobeSample out;
    out.direction = reflect(view.out, glm::normalize(half));
    const float cosine = glm::dot(out.direction, view.normal);
    if (cosine > 0)
        out.weight = factor * (2 * cosine / (cosine + view.cosine));
    return out;
}

Rgb Ward::albedo(const LobeView& view) const
{
    const float square = 0.5f * glm::dot(slopes, slopes);
    return factor * (1 + view.cosine * square * std::expm1(-1 / square));
}

} // namespace hipmap
