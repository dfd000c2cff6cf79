#pragma once

#include <glm/glm.hpp>

namespace hipmap {

/// GGX facets that are wider along one direction than across it (Burley 2012; Heitz 2014),
/// docs/light_transport.md (31).  All directions are unit; cosines are to the normal, above zero.
/// With both widths equal they match ggx.h.
struct AnisotropicFacets {
    glm::vec3 along, across, normal; ///< right angles between them
    float alpha_along, alpha_across; ///< widths, above zero

    /// Makes the facets.  along: unit, across the normal.
    AnisotropicFacets(const glm::vec3& shading_normal, const glm::vec3& wide, float wide_alpha,
                      float narrow_alpha)
        : along(wide), across(glm::cross(shading_normal, wide)), normal(shading_normal),
          alpha_along(wide_alpha), alpha_across(narrow_alpha)
    {
    }

    /// Returns s(v), from which masking is computed; s(-v) = s(v).
    float slope(const glm::vec3& direction) const;

    /// Returns D(h), per solid angle.
    float distribution(const glm::vec3& half) const;

    /// Returns D G2 / (4 cos_in cos_out), finite unless both cosines are zero.
    float spread(const glm::vec3& in, const glm::vec3& out, const glm::vec3& half) const;

    /// Returns G2 / G1(out), in [0, 1].
    float shadowing(const glm::vec3& in, float cos_in, const glm::vec3& out, float cos_out) const;

    /// Returns the pdf of the direction that a facet drawn by `sample` reflects `out` into, by its
    /// half vector.
    float reflected_pdf(const glm::vec3& out, const glm::vec3& half) const;

    /// Returns the pdf with which `sample` draws `half`; 0 for facets turned away.
    float pdf(const glm::vec3& out, const glm::vec3& half) const;

    /// Draws the normal of a facet, in proportion to what is visible from `out`.  u: [0, 1)^2.
    glm::vec3 sample(const glm::vec3& out, const glm::vec2& u) const;
};

} // namespace hipmap
