#include "render/lights/spot_cone.h"

#include "common/math/frame.h"
#include "common/math/sampling.h"

#include <algorithm>
#include <cmath>

namespace hipmap {

namespace {

/// The fall-off over the cosine, in two parts: the inner cone, and the rim, where t goes from 0 at
/// the outer cone to 1 at the inner one.  Their shares of the integral over cosines.
struct ConeParts {
    double inner, rim;
};

double rim_width(const SpotCone& cone)
{
    return double{cone.cos_inner} - double{cone.cos_outer};
}

/// The integral of the fall-off from the outer cone to t, over t: docs/light_transport.md (39).
double rim_integral(const SpotCone& cone, double t)
{
    const double t3 = t * t * t, smooth = t3 * (1 - t / 2);
    switch (cone.falloff) {
    case SpotFalloff::smooth:
        return smooth;
    case SpotFalloff::smooth_cosine:
        return cone.cos_outer * smooth + rim_width(cone) * t3 * t * (0.75 - 0.4 * t);
    case SpotFalloff::gltf:
        break;
    }
    return t3 / 3;
}

/// The fall-off in the rim.
double rim_value(const SpotCone& cone, double t)
{
    const double square = t * t, smooth = square * (3 - 2 * t);
    switch (cone.falloff) {
    case SpotFalloff::smooth:
        return smooth;
    case SpotFalloff::smooth_cosine:
        return smooth * (cone.cos_outer + rim_width(cone) * t);
    case SpotFalloff::gltf:
        break;
    }
    return square;
}

ConeParts parts_of(const SpotCone& cone)
{
    const double inner = cone.cos_inner;
    return {cone.falloff == SpotFalloff::smooth_cosine ? (1 - inner * inner) / 2 : 1 - inner,
            rim_width(cone) * rim_integral(cone, 1)};
}

/// Draws the cosine within the inner cone.  u: [0, 1).
double inner_cosine(const SpotCone& cone, double u)
{
    const double inner = cone.cos_inner;
    if (cone.falloff == SpotFalloff::smooth_cosine)
        return std::sqrt(1 - u * (1 - inner) * (1 + inner));
    return 1 - u * (1 - inner);
}

/// Draws t in the rim.  u: [0, 1).
double rim_place(const SpotCone& cone, double u)
{
    if (cone.falloff == SpotFalloff::gltf)
        return std::cbrt(u);
    // Newton's steps for the share of the integral below t: it is convex, and t^4 is nowhere above
    // it, so that they begin right of the root and come down to it.
    constexpr int kSteps = 20;
    constexpr double kClose = 1e-9;
    const double all = rim_integral(cone, 1);
    double t = std::sqrt(std::sqrt(u));
    for (int i = 0; i < kSteps && t > 0; ++i) {
        const double step = (rim_integral(cone, t) - u * all) / rim_value(cone, t);
        t -= step;
        if (!(step > kClose * t))
            break;
    }
    return std::clamp(t, 0.0, 1.0);
}

} // namespace

float falloff(const SpotCone& cone, const glm::vec3& direction)
{
    const float cosine = glm::dot(direction, cone.direction);
    const float t =
        std::clamp((cosine - cone.cos_outer) / (cone.cos_inner - cone.cos_outer), 0.0f, 1.0f);
    switch (cone.falloff) {
    case SpotFalloff::smooth:
        return t * t * (3 - 2 * t);
    case SpotFalloff::smooth_cosine:
        return t * t * (3 - 2 * t) * std::max(cosine, 0.0f);
    case SpotFalloff::gltf:
        break;
    }
    return t * t;
}

float falloff_integral(const SpotCone& cone)
{
    const ConeParts parts = parts_of(cone);
    return static_cast<float>(2 * double{kPi} * (parts.inner + parts.rim));
}

glm::vec3 sample_direction(const SpotCone& cone, RandomSequence& random)
{
    // Inner cone and rim are picked by their power; within each the pdf follows the fall-off.
    const ConeParts parts = parts_of(cone);
    const double u = random.next() * (parts.inner + parts.rim);
    const double cosine =
        u < parts.inner
            ? inner_cosine(cone, u / parts.inner)
            : cone.cos_outer + rim_width(cone) * rim_place(cone, (u - parts.inner) / parts.rim);
    return Frame(cone.direction)
        .to_world(direction_from_cosine(static_cast<float>(std::min(cosine, 1.0)), random.next()));
}

} // namespace hipmap
