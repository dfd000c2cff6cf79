#include "render/shading/scatter.h"

#include "render/media/phase.h"
#include "render/shading/facet_lobes.h"
#include "render/shading/gathered_scatter.h"

namespace hipmap {

namespace {

/// The clear coat as a surface of its own.
Interaction clearcoat_of(const Interaction& at)
{
    Interaction out = at;
    out.bsdf = clearcoat_alone(at.bsdf);
    if (at.bsdf.coat_agreement < 1) {
        out.shading_normal = at.bsdf.coat_normal;
        out.cosine = glm::dot(at.back, at.bsdf.coat_normal);
    }
    return out;
}

/// What a particle that the coat scatters carries of (9) by its own normal, over that by the
/// surface's.
float coat_correction(const Interaction& at, const glm::vec3& towards)
{
    const auto ratio = [&](const glm::vec3& normal) {
        const float out = std::abs(glm::dot(towards, normal));
        return out > 0 ? std::abs(glm::dot(at.back, normal)) / out : 0.0f;
    };
    const float by_surface = ratio(at.shading_normal);
    return by_surface > 0 ? ratio(at.bsdf.coat_normal) / by_surface : 0.0f;
}

/// Share of light that the lobes scatter below the clear coat; of their facets alone if `facets`.
Rgb share_below_clearcoat(const Interaction& at, Lobes lobes, bool facets)
{
    const Bsdf& bsdf = at.bsdf;
    const float passed = 1 - clearcoat_albedo(bsdf, at.seen().coat);
    Rgb share(0.0f);
    if (lobes == Lobes::gathered) {
        if (!facets)
            share = diffuse_albedo(bsdf, at.seen()) + passed_albedo(bsdf, at.seen()) +
                    passed * sheen_share(bsdf, at.cosine);
        if (bsdf.reflection == Reflection::gathered)
            share += passed * past_sheen(bsdf, at.cosine) * reflection_albedo(bsdf, at.cosine);
        return share;
    }
    if (bsdf.reflection == Reflection::followed)
        share = passed * reflection_albedo(bsdf, at.cosine);
    if (bsdf.glass > 0 && bsdf.alpha > 0) {
        const Rgb reflected =
            glass_reflectance(bsdf, at.cosine, index_beyond(bsdf, at.front, at.solid));
        share += bsdf.glass * (reflected + (1.0f - reflected) * bsdf.glass_tint);
    }
    return share;
}

bool has_clearcoat(const Interaction& at, Lobes lobes)
{
    return at.bsdf.clearcoat != Reflection::none &&
           at.bsdf.clearcoat ==
               (lobes == Lobes::gathered ? Reflection::gathered : Reflection::followed);
}

/// Chance that a direction is drawn from the clear coat.
float clearcoat_chance(const Interaction& at, Lobes lobes, bool facets)
{
    if (!has_clearcoat(at, lobes))
        return 0;
    const float coat = clearcoat_albedo(at.bsdf, at.seen().coat);
    return coat / (coat + max_channel(share_below_clearcoat(at, lobes, facets)));
}

/// Of a surface that has the diffuse lobe alone.
inline Scattered scattered_by_matt(const Interaction& at, const glm::vec3& in)
{
    Scattered out;
    if (glm::dot(in, at.normal) > 0)
        add_diffuse(at, in, 1, out);
    return out;
}

inline ScatterSample sample_matt(const Interaction& at, RandomSequence& random)
{
    ScatterSample out;
    out.direction = sample_diffuse(at, random);
    const Scattered there = scattered_by_matt(at, out.direction);
    out.density = there.density;
    if (there.density > 0)
        out.weight = there.value / there.density;
    return out;
}

Scattered scattered_below_clearcoat(const Interaction& at, const glm::vec3& in, Lobes lobes)
{
    const Bsdf& bsdf = at.bsdf;
    if (lobes == Lobes::gathered)
        return bsdf.gathers() ? scattered_by_gathered(at, in) : Scattered{};
    const bool follows =
        bsdf.reflection == Reflection::followed || (bsdf.glass > 0 && bsdf.alpha > 0);
    return follows ? scattered_by_facets(at, in, lobes) : Scattered{};
}

/// By the phase function of a medium.
Scattered scattered_in_medium(const Interaction& at, const glm::vec3& in, Lobes lobes)
{
    if (lobes != Lobes::gathered)
        return {};
    const float value = phase_value(*at.phase, -glm::dot(at.back, in));
    return {Rgb(value), value};
}

ScatterSample sample_in_medium(const Interaction& at, Lobes lobes, RandomSequence& random)
{
    ScatterSample out;
    out.direction = sample_phase(*at.phase, -at.back, random.next2());
    out.density = scattered_in_medium(at, out.direction, lobes).density;
    out.weight = Rgb(out.density > 0 ? 1.0f : 0.0f);
    return out;
}

ScatterSample sample_below_clearcoat(const Interaction& at, Lobes lobes, RandomSequence& random)
{
    return lobes == Lobes::followed ? sample_own_facets(at, lobes, random)
                                    : sample_gathered(at, random);
}

// Functions of their own, so that matt surfaces are spared their registers.  Media are not matt.

[[gnu::noinline]] Scattered scattered_by_all(const Interaction& at, const glm::vec3& in,
                                             Lobes lobes)
{
    if (at.phase != nullptr)
        return scattered_in_medium(at, in, lobes);
    Scattered out = scattered_below_clearcoat(at, in, lobes);
    const float chance = clearcoat_chance(at, lobes, false);
    if (chance == 0)
        return out;
    const Scattered coat = scattered_by_facets(clearcoat_of(at), in, lobes);
    out.value += coat.value;
    out.density += chance * (coat.density - out.density);
    return out;
}

[[gnu::noinline]] ScatterSample sample_all(const Interaction& at, Lobes lobes,
                                           RandomSequence& random)
{
    if (at.phase != nullptr)
        return sample_in_medium(at, lobes, random);
    const float chance = clearcoat_chance(at, lobes, false);
    if (chance == 0)
        return sample_below_clearcoat(at, lobes, random);
    ScatterSample out = random.next() < chance ? sample_own_facets(clearcoat_of(at), lobes, random)
                                               : sample_below_clearcoat(at, lobes, random);
    if (is_astray(at, out)) {
        out.weight = Rgb(0);
        return out;
    }
    const Scattered there = scattered_by_all(at, out.direction, lobes);
    out.density = there.density;
    out.weight = there.density > 0 ? there.value / there.density : Rgb(0);
    return out;
}

} // namespace

Scattered scattered(const Interaction& at, const glm::vec3& in, Lobes lobes)
{
    if (!at.bsdf.is_matt())
        return scattered_by_all(at, in, lobes);
    return lobes == Lobes::gathered ? scattered_by_matt(at, in) : Scattered{};
}

ScatterSample sample_facets(const Interaction& at, Lobes lobes, RandomSequence& random)
{
    const float chance = clearcoat_chance(at, lobes, true);
    if (chance == 0)
        return sample_own_facets(at, lobes, random);
    const bool coat = random.next() < chance;
    ScatterSample out = sample_own_facets(coat ? clearcoat_of(at) : at, lobes, random);
    out.weight /= coat ? chance : 1 - chance;
    if (coat && at.bsdf.coat_agreement < 1)
        out.weight *= coat_correction(at, out.direction);
    return out;
}

ScatterSample sample_scatter(const Interaction& at, Lobes lobes, RandomSequence& random)
{
    if (!at.bsdf.is_matt())
        return sample_all(at, lobes, random);
    return lobes == Lobes::gathered ? sample_matt(at, random) : ScatterSample{};
}

Rgb scattered_share(const Interaction& at, Lobes lobes)
{
    if (at.bsdf.is_matt())
        return lobes == Lobes::gathered ? at.bsdf.diffuse : Rgb(0);
    const Rgb share = share_below_clearcoat(at, lobes, false);
    return has_clearcoat(at, lobes) ? share + clearcoat_albedo(at.bsdf, at.seen().coat) : share;
}

Ray scattered_ray(const Interaction& at, const ScatterSample& sample)
{
    Ray ray;
    ray.direction = sample.direction;
    ray.origin = offset_origin(at.point, sample.direction);
    return ray;
}

} // namespace hipmap
