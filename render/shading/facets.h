#pragma once

#include "render/shading/bsdf.h"
#include "render/shading/ggx.h"
#include "render/shading/stretched_facets.h"

namespace hipmap {

// The facets of a Bsdf, alike all round (ggx.h) or stretched (stretched_facets.h).  All directions
// are unit; its alpha is above zero.

/// Those of a Bsdf that is stretched.
inline StretchedFacets stretched_facets(const Bsdf& bsdf, const glm::vec3& normal)
{
    return {normal, bsdf.along, bsdf.alpha_along, bsdf.alpha};
}

/// D(h) G2 / (4 cos_in cos_out), docs/light_transport.md (16), (31).  Both directions above the
/// surface.
inline float facet_spread(const Bsdf& bsdf, const glm::vec3& normal, const glm::vec3& in,
                          const glm::vec3& out, const glm::vec3& half)
{
    if (bsdf.is_stretched()) [[unlikely]]
        return stretched_facets(bsdf, normal).spread(in, out, half);
    return ggx_distribution(normal, half, bsdf.alpha) *
           ggx_visibility(glm::dot(normal, in), glm::dot(normal, out), bsdf.alpha);
}

/// What masking leaves of light reflected or transmitted by a facet drawn: G2 / G1(out).  Cosines:
/// to the normal on the side that each direction is on.
inline float facet_shadowing(const Bsdf& bsdf, const glm::vec3& normal, const glm::vec3& in,
                             float cos_in, const glm::vec3& out, float cos_out)
{
    if (bsdf.is_stretched()) [[unlikely]]
        return stretched_facets(bsdf, normal).shadowing(in, cos_in, out, cos_out);
    return ggx_shadowing(cos_in, cos_out, bsdf.alpha);
}

/// Chance per solid angle of `half` that `draw_facet` draws it.
inline float visible_density(const Bsdf& bsdf, const glm::vec3& normal, const glm::vec3& out,
                             const glm::vec3& half)
{
    if (bsdf.is_stretched()) [[unlikely]]
        return stretched_facets(bsdf, normal).density(out, half);
    return facet_density(normal, out, half, bsdf.alpha);
}

/// Chance per solid angle that a facet drawn reflects `out` into the direction whose half vector
/// with it is `half`.
inline float reflected_density(const Bsdf& bsdf, const glm::vec3& normal, const glm::vec3& out,
                               const glm::vec3& half)
{
    if (bsdf.is_stretched()) [[unlikely]]
        return stretched_facets(bsdf, normal).reflected_density(out, half);
    return reflected_density(normal, out, half, bsdf.alpha);
}

/// Normal of a facet, as those visible from `out` are distributed.  u: [0, 1)^2.
inline glm::vec3 draw_facet(const Bsdf& bsdf, const glm::vec3& normal, const glm::vec3& out,
                            const glm::vec2& u)
{
    if (bsdf.is_stretched()) [[unlikely]]
        return stretched_facets(bsdf, normal).sample(out, u);
    return sample_facet(normal, out, bsdf.alpha, u);
}

} // namespace hipmap
