#include "render/lobes/microfacet_reflection.h"

#include "common/math/frame.h"
#include "common/math/sampling.h"
#include "render/lobes/glossy_albedo.h"
#include "render/lobes/multiple_scattering.h"

namespace hipmap {

namespace {

Rgb single_albedo(const MicrofacetReflection& lobe, float cosine)
{
    return glossy_albedo(cosine, lobe.facets.alpha).of(lobe.fresnel.f0, lobe.fresnel.f90);
}

/// Probability that a direction is drawn for multiple scattering: 0 without it.
float multiple_probability(const MicrofacetReflection& lobe, float cosine)
{
    if (is_black(lobe.multiple))
        return 0;
    const Rgb multiple = multiple_albedo(lobe.multiple, cosine, lobe.facets.alpha);
    return max_channel(multiple) / max_channel(single_albedo(lobe, cosine) + multiple);
}

} // namespace

Rgb MicrofacetReflection::eval(const LobeView& view, const glm::vec3& in) const
{
    const MirrorFacet facet(in, view.out);
    const Rgb single = fresnel(facet.toward) * facets.spread(view, in, facet.half);
    return is_black(multiple) ? single
                              : single + multiple_scattering(multiple, glm::dot(view.normal, in),
                                                             view.cosine, facets.alpha);
}

float MicrofacetReflection::pdf(const LobeView& view, const glm::vec3& in) const
{
    const float single = facets.reflected_pdf(view, MirrorFacet(in, view.out).half);
    const float probability = multiple_probability(*this, view.cosine);
    return single + probability * (glm::dot(view.normal, in) / kPi - single);
}

LobeSample MicrofacetReflection::sample(const LobeView& view, RandomSequence& random) const
{
    const float probability = multiple_probability(*this, view.cosine);
    const glm::vec2 u = random.next2();
    LobeSample out;
    if (probability > 0 && random.next() < probability) {
        out.direction = Frame(view.normal).to_world(sample_cosine_hemisphere(u));
    } else {
        const glm::vec3 half = facets.sample(view, u);
        out.direction = reflect(view.out, half);
        const float cosine = glm::dot(out.direction, view.normal);
        if (!(cosine > 0))
            return out;
        out.weight =
            fresnel(glm::dot(view.out, half)) * facets.shadowing(view, out.direction, cosine);
    }
    if (probability > 0)
        out.weight = eval(view, out.direction) *
                     (glm::dot(out.direction, view.normal) / pdf(view, out.direction));
    return out;
}

Rgb MicrofacetReflection::albedo(const LobeView& view) const
{
    const Rgb single = single_albedo(*this, view.cosine);
    return is_black(multiple) ? single
                              : single + multiple_albedo(multiple, view.cosine, facets.alpha);
}

} // namespace hipmap
