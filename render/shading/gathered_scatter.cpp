#include "render/shading/gathered_scatter.h"

#include "render/shading/facet_lobes.h"

namespace hipmap {

namespace {

/// Chances that a gathered direction is drawn from facets and fibres, and from light that passes,
/// not from the diffuse lobe.
struct GatheredChances {
    float facets = 0.0f, sheen = 0.0f, beyond = 0.0f;
};

GatheredChances gathered_chances(const Interaction& at)
{
    GatheredChances out;
    if (at.bsdf.reflection == Reflection::gathered)
        out.facets = max_channel(reflection_albedo(at.bsdf, at.cosine));
    out.sheen = max_channel(sheen_share(at.bsdf, at.cosine));
    out.beyond = max_channel(passed_albedo(at.bsdf, at.seen()));
    const float others = out.facets + out.sheen + out.beyond;
    if (!(others > 0))
        return {};
    const float sum = others + max_channel(diffuse_albedo(at.bsdf, at.seen()));
    return {out.facets / sum, out.sheen / sum, out.beyond / sum};
}

constexpr float kEvenDensity = 1 / (2 * kPi); ///< over the hemisphere, by which sheen is drawn

/// in: above the face.
Scattered scattered_by_fibres(const Interaction& at, const glm::vec3& in)
{
    const float cosine = glm::dot(in, at.shading_normal);
    if (!(cosine > 0))
        return {};
    return {scattered_by_sheen(at.bsdf, at.shading_normal, in, at.back) * cosine, kEvenDensity};
}

glm::vec3 sample_evenly(const Interaction& at, RandomSequence& random)
{
    const glm::vec2 u = random.next2();
    return Frame(at.shading_normal).to_world(direction_from_cosine(u.x, u.y));
}

/// What passes diffusely, of which `chance` is drawn.  in: not above the face.
Scattered passed(const Interaction& at, const glm::vec3& in, float chance)
{
    const float cosine = -glm::dot(in, at.shading_normal);
    if (!(chance > 0) || !(cosine > 0))
        return {};
    const GatheredLobes lobes(at.bsdf, at.shading_normal, at.normal, at.back);
    return {lobes(in) * cosine, chance * cosine / kPi};
}

Scattered gathered(const Interaction& at, const glm::vec3& in, const GatheredChances& chances)
{
    if (!(glm::dot(in, at.normal) > 0))
        return passed(at, in, chances.beyond);
    Scattered out;
    if (chances.facets > 0) {
        out = scattered_by_facets(at, in, Lobes::gathered);
        out.density *= chances.facets;
    }
    if (chances.sheen > 0) {
        const Scattered sheen = scattered_by_fibres(at, in);
        out.value += sheen.value;
        out.density += chances.sheen * sheen.density;
    }
    add_diffuse(at, in, 1 - chances.facets - chances.sheen - chances.beyond, out);
    return out;
}

} // namespace

Scattered scattered_by_gathered(const Interaction& at, const glm::vec3& in)
{
    return gathered(at, in, gathered_chances(at));
}

ScatterSample sample_gathered(const Interaction& at, RandomSequence& random)
{
    const GatheredChances chances = gathered_chances(at);
    const float glossy = chances.facets + chances.sheen, others = glossy + chances.beyond;
    const float drawn = others > 0 ? random.next() : 1.0f;
    ScatterSample out;
    out.transmitted = drawn >= glossy && drawn < others;
    if (drawn < chances.facets)
        out.direction = sample_own_facets(at, Lobes::gathered, random).direction;
    else if (drawn < glossy)
        out.direction = sample_evenly(at, random);
    else
        out.direction = sample_diffuse(at, random);
    if (out.transmitted)
        out.direction = mirrored(out.direction, at.shading_normal);
    if (is_astray(at, out))
        return out;
    const Scattered there = gathered(at, out.direction, chances);
    out.density = there.density;
    if (there.density > 0)
        out.weight = there.value / there.density;
    return out;
}

ScatterSample sample_sheen(const Interaction& at, RandomSequence& random)
{
    ScatterSample out;
    out.direction = sample_evenly(at, random);
    if (!(glm::dot(out.direction, at.normal) > 0))
        return out;
    const Scattered there = scattered_by_fibres(at, out.direction);
    out.density = there.density;
    out.weight = there.value / kEvenDensity;
    return out;
}

} // namespace hipmap
