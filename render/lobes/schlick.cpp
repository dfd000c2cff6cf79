#include "render/lobes/schlick.h"

#include "common/math/frame.h"
#include "common/math/sampling.h"
#include "render/lobes/ggx.h"
#include "render/lobes/glossy_albedo.h"

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

SchlickShares shares_of(const Schlick& lobe)
{
    return schlick_shares(lobe.alpha * lobe.alpha);
}

/// A(w): more light where the half vector leans along the tangent than across it.
float azimuth_factor(const Schlick& lobe, const LobeView& view, const glm::vec3& half)
{
    if (!(lobe.isotropy < 1) || !view.has_tangent())
        return 1;
    const float x = glm::dot(half, glm::cross(view.normal, view.tangent));
    const float y = glm::dot(half, view.tangent);
    const float p = lobe.isotropy, sine2 = x * x + y * y;
    return sine2 > 0 ? std::sqrt(p * sine2 / (p * p * y * y + x * x)) : 1;
}

/// G(v) G(v') Z(t) A(w) / (4 pi v v'), of what is spread.
float spread(const Schlick& lobe, const LobeView& view, const glm::vec3& in, const glm::vec3& half)
{
    // G(c)/c, of which the cosines cancel.
    const auto masking = [k = 0.5f * lobe.alpha](float cosine) {
        return k * (1 - cosine) + cosine;
    };
    const float visibility =
        0.25f / (masking(glm::dot(in, view.normal)) * masking(glm::dot(view.out, view.normal)));
    return ggx_distribution(view.normal, half, lobe.alpha) * visibility * // Z/pi is GGX's
           azimuth_factor(lobe, view, half);
}

} // namespace

Rgb Schlick::eval(const LobeView& view, const glm::vec3& in) const
{
    const SchlickShares shares = shares_of(*this);
    const glm::vec3 half = glm::normalize(in + view.out);
    const Rgb reflected = fresnel(glm::dot(half, view.out));
    return reflected * (shares.spread * spread(*this, view, in, half)) +
           (reflected - fresnel.f0) * (shares.even / kPi);
}

float Schlick::pdf(const LobeView& view, const glm::vec3& in) const
{
    const float even = shares_of(*this).even;
    const glm::vec3 half = glm::normalize(in + view.out);
    return even * glm::dot(in, view.normal) / kPi +
           (1 - even) * ggx_reflected_pdf(view.normal, view.out, half, alpha);
}

LobeSample Schlick::sample(const LobeView& view, RandomSequence& random) const
{
    const glm::vec2 u = random.next2();
    const float even = shares_of(*this).even;
    LobeSample out;
    out.direction = even > 0 && random.next() < even
                        ? Frame(view.normal).to_world(sample_cosine_hemisphere(u))
                        : reflect(view.out, sample_facet(view.normal, view.out, alpha, u));
    const float cosine = glm::dot(out.direction, view.normal);
    if (cosine > 0)
        out.weight = eval(view, out.direction) * (cosine / pdf(view, out.direction));
    return out;
}

Rgb Schlick::albedo(const LobeView& view) const
{
    const SchlickShares shares = shares_of(*this);
    return shares.spread * glossy_albedo(view.cosine, alpha).of(fresnel.f0, fresnel.f90) +
           shares.even / 21 * (1.0f - fresnel.f0);
}

} // namespace hipmap
