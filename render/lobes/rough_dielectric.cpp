#include "render/lobes/rough_dielectric.h"

#include "render/lobes/fresnel.h"

namespace hipmap {

namespace {

/// The shares of light that a facet reflects and transmits.
struct FacetShares {
    Rgb reflect, transmit;

    /// cosine: between `out` and the facet's normal.
    FacetShares(const RoughDielectric& lobe, const LobeView& view, float cosine)
    {
        const Rgb reflected = scaled_fresnel(cosine, view.eta, lobe.reflection);
        reflect = lobe.share * reflected;
        transmit = lobe.share * (1.0f - reflected) * lobe.tint;
    }

    /// Probability that a facet drawn reflects; else it transmits.
    float reflect_probability() const
    {
        const float reflected = max_channel(reflect);
        const float sum = reflected + max_channel(transmit);
        return sum > 0 ? reflected / sum : 1;
    }
};

/// Refraction of `out` to `in` by one facet, docs/light_transport.md (17).
struct RefractingFacet {
    glm::vec3 half;
    float toward, behind;  ///< cosines of `out` and `in` to it
    float jacobian = 0.0f; ///< of the half vector by `in`; 0: no facet refracts one to the other

    RefractingFacet(const LobeView& view, const glm::vec3& in)
    {
        const glm::vec3 both = view.out + view.eta * in;
        half = glm::normalize(view.eta > 1 ? -both : both);
        toward = glm::dot(view.out, half);
        behind = glm::dot(in, half);
        if (!(toward > 0) || !(behind < 0))
            return;
        const float stretch = toward + view.eta * behind;
        jacobian = view.eta * view.eta * -behind / (stretch * stretch);
    }
};

/// `in` on the side of `out` as a thin wall's facets reflect it before it goes straight through.
glm::vec3 unfolded(const LobeView& view, const glm::vec3& in)
{
    return mirrored(in, view.normal);
}

Rgb eval_refracted(const RoughDielectric& lobe, const LobeView& view, const glm::vec3& in)
{
    const RefractingFacet facet(view, in);
    if (!(facet.jacobian > 0))
        return Rgb(0);
    const float cosine = -glm::dot(in, view.normal);
    const float passed = lobe.facets.shadowing(view, in, cosine) *
                         lobe.facets.pdf(view, facet.half) * facet.jacobian;
    return FacetShares(lobe, view, facet.toward).transmit *
           (passed / (view.eta * view.eta * cosine));
}

} // namespace

Rgb RoughDielectric::eval(const LobeView& view, const glm::vec3& in) const
{
    const bool transmitted = glm::dot(in, view.normal) < 0;
    if (transmitted && view.solid)
        return eval_refracted(*this, view, in);
    const glm::vec3 above = transmitted ? unfolded(view, in) : in;
    const MirrorFacet facet(above, view.out);
    const FacetShares shares(*this, view, facet.toward);
    return (transmitted ? shares.transmit : shares.reflect) *
           facets.spread(view, above, facet.half);
}

float RoughDielectric::pdf(const LobeView& view, const glm::vec3& in) const
{
    const bool transmitted = glm::dot(in, view.normal) < 0;
    if (transmitted && view.solid) {
        const RefractingFacet facet(view, in);
        if (!(facet.jacobian > 0))
            return 0;
        return (1 - FacetShares(*this, view, facet.toward).reflect_probability()) *
               facets.pdf(view, facet.half) * facet.jacobian;
    }
    const MirrorFacet facet(transmitted ? unfolded(view, in) : in, view.out);
    const float reflect = FacetShares(*this, view, facet.toward).reflect_probability();
    return (transmitted ? 1 - reflect : reflect) * facets.reflected_pdf(view, facet.half);
}

LobeSample RoughDielectric::sample(const LobeView& view, RandomSequence& random) const
{
    const glm::vec3 half = facets.sample(view, random.next2());
    const FacetShares shares(*this, view, glm::dot(view.out, half));
    const float probability = shares.reflect_probability();
    LobeSample out;
    out.transmitted = !(random.next() < probability);
    if (!out.transmitted) {
        out.direction = reflect(view.out, half);
    } else if (view.solid) {
        out.eta = view.eta;
        out.direction = refract(view.out, half, view.eta);
    } else {
        out.direction = mirrored(reflect(view.out, half), view.normal);
    }
    const float cosine = (out.transmitted ? -1.0f : 1.0f) * glm::dot(out.direction, view.normal);
    if (!(cosine > 0))
        return out;
    out.weight =
        (out.transmitted ? shares.transmit / (1 - probability) : shares.reflect / probability) *
        facets.shadowing(view, out.direction, cosine);
    return out;
}

Rgb RoughDielectric::albedo(const LobeView& view) const
{
    const FacetShares shares(*this, view, view.cosine);
    return shares.reflect + shares.transmit;
}

} // namespace hipmap
