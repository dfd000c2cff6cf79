#include "render/shading/facet_lobes.h"

#include "common/math/frame.h"
#include "common/math/sampling.h"
#include "render/shading/energy_compensation.h"
#include "render/shading/facets.h"
#include "render/shading/reflection_models.h"

namespace hipmap {

namespace {

/// Of light that meets a facet, what the lobes reflect and transmit.
struct FacetShares {
    Rgb reflect{0.0f};
    Rgb transmit{0.0f};

    /// Chance that a facet drawn reflects; else it transmits.
    float reflect_chance() const
    {
        const float reflected = max_channel(reflect);
        const float sum = reflected + max_channel(transmit);
        return sum > 0 ? reflected / sum : 1;
    }
};

bool has_reflection(const Bsdf& bsdf, Lobes lobes)
{
    return bsdf.reflection ==
           (lobes == Lobes::gathered ? Reflection::gathered : Reflection::followed);
}

/// cosine: between the direction and the facet's normal.
FacetShares facet_shares(const Interaction& at, Lobes lobes, float cosine)
{
    const Bsdf& bsdf = at.bsdf;
    FacetShares out;
    if (has_reflection(bsdf, lobes))
        out.reflect = opaque_reflectance(bsdf, cosine);
    if (lobes == Lobes::followed && bsdf.glass > 0 && bsdf.alpha > 0) {
        const Rgb reflected =
            glass_reflectance(bsdf, cosine, index_beyond(at.bsdf, at.front, at.solid));
        out.reflect += bsdf.glass * reflected;
        out.transmit = bsdf.glass * (1.0f - reflected) * bsdf.glass_tint;
    }
    return out;
}

/// The facet that reflects one direction into the other.
struct MirrorFacet {
    glm::vec3 half{0.0f};
    float toward =
        0.0f; ///< its cosine with both, by the length of their sum: where they are nearly
              ///<   opposite, the dot product may come out below zero
};

MirrorFacet facet_between(const glm::vec3& in, const glm::vec3& back)
{
    const glm::vec3 sum = in + back;
    const float length = glm::length(sum);
    return {sum / length, length / 2};
}

/// Light that facets reflect into the side it came from.
Scattered reflected(const Interaction& at, const glm::vec3& in, Lobes lobes)
{
    const auto [half, toward] = facet_between(in, at.back);
    const float cosine = glm::dot(in, at.shading_normal);
    const FacetShares shares = facet_shares(at, lobes, toward);
    const float spread = facet_spread(at.bsdf, at.shading_normal, in, at.back, half) * cosine;
    Scattered out;
    out.value = shares.reflect *
                (spread * through_layers(at.bsdf, incidence(at.bsdf, in, cosine), at.seen()));
    out.density =
        shares.reflect_chance() * reflected_density(at.bsdf, at.shading_normal, at.back, half);
    return out;
}

/// Light that facets pass on through a thin wall: as reflected, but on the other side.
Scattered passed(const Interaction& at, const glm::vec3& in)
{
    const glm::vec3 image = mirrored(in, at.shading_normal);
    const auto [half, toward] = facet_between(image, at.back);
    const float cosine = glm::dot(image, at.shading_normal);
    const FacetShares shares = facet_shares(at, Lobes::followed, toward);
    const float spread = facet_spread(at.bsdf, at.shading_normal, image, at.back, half) * cosine;
    Scattered out;
    out.value = shares.transmit * spread;
    out.density = (1 - shares.reflect_chance()) *
                  reflected_density(at.bsdf, at.shading_normal, at.back, half);
    return out;
}

/// Light that facets refract into a solid, or out of it.  docs/light_transport.md (17).
Scattered refracted(const Interaction& at, const glm::vec3& in)
{
    const float eta = index_beyond(at.bsdf, at.front, at.solid);
    const glm::vec3 both = at.back + eta * in;
    const glm::vec3 half = glm::normalize(eta > 1 ? -both : both);
    const float toward = glm::dot(at.back, half), beyond = glm::dot(in, half);
    if (!(toward > 0) || !(beyond < 0))
        return {};
    const FacetShares shares = facet_shares(at, Lobes::followed, toward);
    const float stretch = toward + eta * beyond;
    const float jacobian = eta * eta * -beyond / (stretch * stretch);
    const float visible = visible_density(at.bsdf, at.shading_normal, at.back, half);
    const float cosine = -glm::dot(in, at.shading_normal);
    Scattered out;
    out.density = (1 - shares.reflect_chance()) * visible * jacobian;
    out.value = shares.transmit *
                (facet_shadowing(at.bsdf, at.shading_normal, in, cosine, at.back, at.cosine) *
                 visible * jacobian / (eta * eta));
    return out;
}

/// Without what is folded.  beyond: light that passes the surface.
Scattered by_one_facet(const Interaction& at, const glm::vec3& in, Lobes lobes, bool beyond)
{
    const float cosine = glm::dot(in, at.shading_normal);
    if (!((beyond ? -cosine : cosine) > 0))
        return {};
    if (!beyond)
        return reflected(at, in, lobes);
    return at.solid ? refracted(at, in) : passed(at, in);
}

/// The lobes have what facets pass to one another.
bool regains(const Interaction& at, Lobes lobes)
{
    return at.bsdf.is_compensated() && has_reflection(at.bsdf, lobes);
}

/// Chance that a direction is drawn by that, where there is some.
float regained_chance(const Interaction& at)
{
    return max_channel(regained_albedo(at.bsdf, at.cosine)) /
           (max_channel(reflection_albedo(at.bsdf, at.cosine)) + at.bsdf.glass);
}

/// By Phong's or Schlick's model, which has no facets but spreads light as they do.
Scattered by_model(const Interaction& at, const glm::vec3& in, bool beyond)
{
    const float cosine = glm::dot(in, at.shading_normal);
    if (beyond || !(cosine > 0))
        return {};
    return {modelled_lobe(at.bsdf, at.shading_normal, in, at.back) * cosine,
            modelled_density(at.bsdf, at.shading_normal, in, at.back)};
}

/// As `by_one_facet`, of facets that light may meet one after another.
Scattered unfolded(const Interaction& at, const glm::vec3& in, Lobes lobes, bool beyond)
{
    if (at.bsdf.is_modelled()) [[unlikely]]
        return by_model(at, in, beyond);
    Scattered out = by_one_facet(at, in, lobes, beyond);
    if (!regains(at, lobes))
        return out;
    const float chance = regained_chance(at);
    out.density *= 1 - chance;
    const float cosine = glm::dot(in, at.shading_normal);
    if (beyond || !(cosine > 0))
        return out;
    out.value += regained_lobe(at.bsdf, cosine, at.cosine) *
                 (cosine * through_layers(at.bsdf, incidence(at.bsdf, in, cosine), at.seen()));
    out.density += chance * cosine / kPi;
    return out;
}

} // namespace

Scattered scattered_by_facets(const Interaction& at, const glm::vec3& in, Lobes lobes)
{
    const bool beyond = glm::dot(in, at.normal) < 0;
    if (beyond && (lobes == Lobes::gathered || !(at.bsdf.glass > 0)))
        return {};
    Scattered out = unfolded(at, in, lobes, beyond);
    if (at.shading_normal != at.normal) {
        const Scattered folded = unfolded(at, mirrored(in, at.normal), lobes, beyond);
        out.value += folded.value;
        out.density += folded.density;
    }
    return out;
}

namespace {

ScatterSample sample_one_facet(const Interaction& at, Lobes lobes, RandomSequence& random)
{
    const glm::vec2 u = random.next2();
    const glm::vec3 half = draw_facet(at.bsdf, at.shading_normal, at.back, u);
    const FacetShares shares = facet_shares(at, lobes, glm::dot(at.back, half));
    const float chance = shares.reflect_chance();
    ScatterSample out;
    out.transmitted = !(random.next() < chance);
    if (!out.transmitted) {
        out.direction = reflect(at.back, half);
    } else if (at.solid) {
        out.eta = index_beyond(at.bsdf, at.front, at.solid);
        out.direction = refract(at.back, half, out.eta);
    } else {
        out.direction = mirrored(reflect(at.back, half), at.shading_normal);
    }
    const float sign = out.transmitted ? -1.0f : 1.0f;
    const float cosine = sign * glm::dot(out.direction, at.shading_normal);
    if (!(cosine > 0))
        return out;
    const glm::vec3 toward = out.direction;
    if (sign * glm::dot(out.direction, at.normal) < 0) // bent past the face by the shading normal
        out.direction = mirrored(out.direction, at.normal);
    const Rgb share = out.transmitted ? shares.transmit / (1 - chance) : shares.reflect / chance;
    out.weight =
        share * (facet_shadowing(at.bsdf, at.shading_normal, toward, cosine, at.back, at.cosine) *
                 through_layers(at.bsdf, incidence(at.bsdf, toward, cosine), at.seen()));
    out.density = scattered_by_facets(at, out.direction, lobes).density;
    return out;
}

/// Of a direction drawn about the shading normal, which may lie past the face.
ScatterSample folded_back(const Interaction& at, const glm::vec3& direction)
{
    ScatterSample out;
    out.direction = glm::dot(direction, at.normal) < 0 ? mirrored(direction, at.normal) : direction;
    return out;
}

/// Gives what was drawn in any way its density and weight.
void weigh(const Interaction& at, Lobes lobes, ScatterSample& out)
{
    const Scattered there = scattered_by_facets(at, out.direction, lobes);
    out.density = there.density;
    out.weight = there.density > 0 ? there.value * (out.eta * out.eta / there.density) : Rgb(0);
}

/// By the cosine, or a facet.
ScatterSample sample_with_regained(const Interaction& at, Lobes lobes, RandomSequence& random)
{
    ScatterSample out;
    if (random.next() < regained_chance(at)) {
        out = folded_back(
            at, Frame(at.shading_normal).to_world(sample_cosine_hemisphere(random.next2())));
    } else {
        out = sample_one_facet(at, lobes, random);
        if (is_black(out.weight))
            return out;
    }
    weigh(at, lobes, out);
    return out;
}

ScatterSample sample_model(const Interaction& at, Lobes lobes, RandomSequence& random)
{
    ScatterSample out;
    out.direction = draw_modelled(at.bsdf, at.shading_normal, at.back, random);
    if (!(glm::dot(out.direction, at.shading_normal) > 0))
        return out;
    out = folded_back(at, out.direction);
    weigh(at, lobes, out);
    return out;
}

} // namespace

ScatterSample sample_own_facets(const Interaction& at, Lobes lobes, RandomSequence& random)
{
    if (at.bsdf.is_modelled()) [[unlikely]]
        return sample_model(at, lobes, random);
    return regains(at, lobes) ? sample_with_regained(at, lobes, random)
                              : sample_one_facet(at, lobes, random);
}

} // namespace hipmap
