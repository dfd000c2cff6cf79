#pragma once

#include <glm/glm.hpp>

namespace hipmap {

/// GGX facets that are wider along one direction than across it (Burley 2012; Heitz 2014),
/// docs/light_transport.md (31).  All directions are unit; cosines are those to the normal, above
/// zero.  With both widths the same they are those of ggx.h.
struct AnisotropicFacets {
    glm::vec3 along, across, normal; ///< right angles between them
    float alpha_along, alpha_across; ///< widths, above zero

    /// along: across the normal.
    AnisotropicFacets(const glm::vec3& shading_normal, const glm::vec3& wide, float wide_alpha,
                      float narrow_alpha)
        : along(wide), across(glm::cross(shading_normal, wide)), normal(shading_normal),
          alpha_along(wide_alpha), alpha_across(narrow_alpha)
    {
    }

    /// s(v), of which masking is made; that of -v is the same.
    float slope(const glm::vec3& direction) const;

    /// D(h), per solid angle.
    float distribution(const glm::vec3& half) const;

    /// D G2 / (4 cos_in cos_out), finite unless both cosines are zero.
    float spread(const glm::vec3& in, const glm::vec3& out, const glm::vec3& half) const;

    /// G2 / G1(out), in [0, 1].
    float shadowing(const glm::vec3& in, float cos_in, const glm::vec3& out, float cos_out) const;

    /// As that of ggx.h.
    float reflected_pdf(const glm::vec3& out, const glm::vec3& half) const;

    /// Pdf of `half` that `sample` draws it; 0 for facets turned away.
    float pdf(const glm::vec3& out, const glm::vec3& half) const;

    /// Normal of a facet, as those visible from `out` are distributed.  u: [0, 1)^2.
    glm::vec3 sample(const glm::vec3& out, const glm::vec2& u) const;
};

} // namespace hipmap
