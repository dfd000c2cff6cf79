#include "render/shading/scatter.h"

#include "common/math/frame.h"
#include "common/math/sampling.h"
#include "render/shading/gathered_lobes.h"
#include "render/shading/ggx.h"

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

float index_of(const Interaction& at)
{
    return index_beyond(at.bsdf, at.front, at.solid);
}

/// cosine: between the direction and the facet's normal.
FacetShares facet_shares(const Interaction& at, Lobes lobes, float cosine)
{
    const Bsdf& bsdf = at.bsdf;
    FacetShares out;
    const Reflection wanted =
        lobes == Lobes::gathered ? Reflection::gathered : Reflection::followed;
    if (bsdf.reflection == wanted)
        out.reflect = opaque_reflectance(bsdf, cosine);
    if (lobes == Lobes::followed && bsdf.glass > 0 && bsdf.alpha > 0) {
        const Rgb reflected = glass_reflectance(bsdf, cosine, index_of(at));
        out.reflect += bsdf.glass * reflected;
        out.transmit = bsdf.glass * (1.0f - reflected) * bsdf.glass_tint;
    }
    return out;
}

/// Light that facets reflect into the side it came from.
Scattered reflected(const Interaction& at, const glm::vec3& in, Lobes lobes)
{
    const float alpha = at.bsdf.alpha;
    const glm::vec3 half = glm::normalize(in + at.back);
    const float cosine = glm::dot(in, at.shading_normal);
    const float toward = glm::dot(at.back, half);
    const FacetShares shares = facet_shares(at, lobes, toward);
    const float spread = ggx_distribution(at.shading_normal, half, alpha) *
                         ggx_visibility(cosine, at.cosine, alpha) * cosine;
    Scattered out;
    out.value = shares.reflect * spread;
    out.density = shares.reflect_chance() * facet_density(at.shading_normal, at.back, half, alpha) /
                  (4 * toward);
    return out;
}

/// Light that facets pass on through a thin wall: as reflected, but on the other side.
Scattered passed(const Interaction& at, const glm::vec3& in)
{
    const float alpha = at.bsdf.alpha;
    const glm::vec3 image = mirrored(in, at.shading_normal);
    const glm::vec3 half = glm::normalize(image + at.back);
    const float cosine = glm::dot(image, at.shading_normal);
    const float toward = glm::dot(at.back, half);
    const FacetShares shares = facet_shares(at, Lobes::followed, toward);
    const float spread = ggx_distribution(at.shading_normal, half, alpha) *
                         ggx_visibility(cosine, at.cosine, alpha) * cosine;
    Scattered out;
    out.value = shares.transmit * spread;
    out.density = (1 - shares.reflect_chance()) *
                  facet_density(at.shading_normal, at.back, half, alpha) / (4 * toward);
    return out;
}

/// Light that facets refract into a solid, or out of it.  docs/light_transport.md (17).
Scattered refracted(const Interaction& at, const glm::vec3& in)
{
    const float eta = index_of(at), alpha = at.bsdf.alpha;
    const glm::vec3 both = at.back + eta * in;
    const glm::vec3 half = glm::normalize(eta > 1 ? -both : both);
    const float toward = glm::dot(at.back, half), beyond = glm::dot(in, half);
    if (!(toward > 0) || !(beyond < 0))
        return {};
    const FacetShares shares = facet_shares(at, Lobes::followed, toward);
    const float stretch = toward + eta * beyond;
    const float jacobian = eta * eta * -beyond / (stretch * stretch);
    const float visible = facet_density(at.shading_normal, at.back, half, alpha);
    const float cosine = -glm::dot(in, at.shading_normal);
    Scattered out;
    out.density = (1 - shares.reflect_chance()) * visible * jacobian;
    out.value = shares.transmit *
                (ggx_shadowing(cosine, at.cosine, alpha) * visible * jacobian / (eta * eta));
    return out;
}

/// Without what is folded.  beyond: light that passes the surface.
Scattered unfolded(const Interaction& at, const glm::vec3& in, Lobes lobes, bool beyond)
{
    const float cosine = glm::dot(in, at.shading_normal);
    if (!((beyond ? -cosine : cosine) > 0))
        return {};
    if (!beyond)
        return reflected(at, in, lobes);
    return at.solid ? refracted(at, in) : passed(at, in);
}

/// docs/light_transport.md (16), (17) and (19).
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

/// Chance that a gathered direction is drawn from the facets.
float facet_chance(const Interaction& at)
{
    if (at.bsdf.reflection != Reflection::gathered)
        return 0;
    const float glossy = max_channel(reflection_albedo(at.bsdf, at.cosine));
    const float sum = glossy + max_channel(diffuse_albedo(at.bsdf, at.cosine));
    return sum > 0 ? glossy / sum : 0;
}

/// facets: the chance above.
Scattered gathered(const Interaction& at, const glm::vec3& in, float facets)
{
    if (!(glm::dot(in, at.normal) > 0))
        return {};
    Scattered out;
    if (facets > 0) {
        out = scattered_by_facets(at, in, Lobes::gathered);
        out.density *= facets;
    }
    const float cosine = glm::dot(in, at.shading_normal);
    if (cosine > 0) {
        const GatheredLobes lobes(at.bsdf, at.shading_normal, at.normal, at.back);
        out.value += lobes.diffuse(in, cosine) * cosine;
        out.density += (1 - facets) * cosine / kPi;
    }
    return out;
}

} // namespace

Scattered scattered(const Interaction& at, const glm::vec3& in, Lobes lobes)
{
    if (lobes == Lobes::gathered)
        return at.bsdf.gathers() ? gathered(at, in, facet_chance(at)) : Scattered{};
    return at.bsdf.follows() ? scattered_by_facets(at, in, lobes) : Scattered{};
}

ScatterSample sample_facets(const Interaction& at, Lobes lobes, RandomSequence& random)
{
    const glm::vec2 u = random.next2();
    const glm::vec3 half = sample_facet(at.shading_normal, at.back, at.bsdf.alpha, u);
    const FacetShares shares = facet_shares(at, lobes, glm::dot(at.back, half));
    const float chance = shares.reflect_chance();
    ScatterSample out;
    out.transmitted = !(random.next() < chance);
    if (!out.transmitted) {
        out.direction = reflect(at.back, half);
    } else if (at.solid) {
        out.eta = index_of(at);
        out.direction = refract(at.back, half, out.eta);
    } else {
        out.direction = mirrored(reflect(at.back, half), at.shading_normal);
    }
    const float sign = out.transmitted ? -1.0f : 1.0f;
    const float cosine = sign * glm::dot(out.direction, at.shading_normal);
    if (!(cosine > 0))
        return out;
    if (sign * glm::dot(out.direction, at.normal) < 0) // bent past the face by the shading normal
        out.direction = mirrored(out.direction, at.normal);
    const Rgb share = out.transmitted ? shares.transmit / (1 - chance) : shares.reflect / chance;
    out.weight = share * ggx_shadowing(cosine, at.cosine, at.bsdf.alpha);
    out.density = scattered_by_facets(at, out.direction, lobes).density;
    return out;
}

ScatterSample sample_scatter(const Interaction& at, Lobes lobes, RandomSequence& random)
{
    if (lobes == Lobes::followed)
        return sample_facets(at, lobes, random);
    const float facets = facet_chance(at);
    ScatterSample out;
    if (facets > 0 && random.next() < facets)
        out.direction = sample_facets(at, lobes, random).direction;
    else
        out.direction = Frame(at.shading_normal).to_world(sample_cosine_hemisphere(random.next2()));
    const Scattered there = gathered(at, out.direction, facets);
    out.density = there.density;
    if (there.density > 0)
        out.weight = there.value / there.density;
    return out;
}

Rgb scattered_share(const Interaction& at, Lobes lobes)
{
    const Bsdf& bsdf = at.bsdf;
    if (lobes == Lobes::gathered) {
        const Rgb diffuse = diffuse_albedo(bsdf, at.cosine);
        return bsdf.reflection == Reflection::gathered
                   ? diffuse + reflection_albedo(bsdf, at.cosine)
                   : diffuse;
    }
    Rgb share(0.0f);
    if (bsdf.reflection == Reflection::followed)
        share = reflection_albedo(bsdf, at.cosine);
    if (bsdf.glass > 0 && bsdf.alpha > 0) {
        const Rgb reflected = glass_reflectance(bsdf, at.cosine, index_of(at));
        share += bsdf.glass * (reflected + (1.0f - reflected) * bsdf.glass_tint);
    }
    return share;
}

Ray scattered_ray(const Interaction& at, const ScatterSample& sample)
{
    Ray ray;
    ray.direction = sample.direction;
    ray.origin = offset_origin(at.point, sample.direction);
    return ray;
}

} // namespace hipmap
