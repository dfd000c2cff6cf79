#pragma once

#include "render/lobes/anisotropic_facets.h"
#include "render/lobes/ggx.h"
#include "render/lobes/lobe_view.h"

namespace hipmap {

/// Distribution of GGX facets, isotropic (ggx.h) or wider along the tangent than across it
/// (anisotropic_facets.h).  Directions are unit, on the side of the view's normal unless said.
struct Facets {
    float alpha = 1.0f;       ///< GGX width, above zero
    float alpha_along = 0.0f; ///< width along the view's tangent; 0: the same as across it

    bool is_anisotropic(const LobeView& view) const
    {
        return alpha_along > 0 && view.has_tangent();
    }

    /// Returns D(h) G2 / (4 cos_in cos_out), docs/light_transport.md (16), (31).
    float spread(const LobeView& view, const glm::vec3& in, const glm::vec3& half) const
    {
        if (is_anisotropic(view)) [[unlikely]]
            return anisotropic(view).spread(in, view.out, half);
        return ggx_distribution(view.normal, half, alpha) *
               ggx_visibility(glm::dot(view.normal, in), view.cosine, alpha);
    }

    /// Returns G2 / G1(out): the share that masking leaves of light that a facet drawn reflects or
    /// transmits. cos_in: of `in` to the normal on the side that `in` is on, which may be the
    /// transmitted side.
    float shadowing(const LobeView& view, const glm::vec3& in, float cos_in) const
    {
        if (is_anisotropic(view)) [[unlikely]]
            return anisotropic(view).shadowing(in, cos_in, view.out, view.cosine);
        return ggx_shadowing(cos_in, view.cosine, alpha);
    }

    /// Returns the pdf per solid angle with which `sample` draws `half`.
    float pdf(const LobeView& view, const glm::vec3& half) const
    {
        if (is_anisotropic(view)) [[unlikely]]
            return anisotropic(view).pdf(view.out, half);
        return ggx_facet_pdf(view.normal, view.out, half, alpha);
    }

    /// Returns the pdf per solid angle with which a facet drawn reflects `out` into the direction
    /// whose half vector with it is `half`.
    float reflected_pdf(const LobeView& view, const glm::vec3& half) const
    {
        if (is_anisotropic(view)) [[unlikely]]
            return anisotropic(view).reflected_pdf(view.out, half);
        return ggx_reflected_pdf(view.normal, view.out, half, alpha);
    }

    /// Draws the normal of a facet, in proportion to what is visible from `out`.  u: [0, 1)^2.
    glm::vec3 sample(const LobeView& view, const glm::vec2& u) const
    {
        if (is_anisotropic(view)) [[unlikely]]
            return anisotropic(view).sample(view.out, u);
        return sample_facet(view.normal, view.out, alpha, u);
    }

  private:
    AnisotropicFacets anisotropic(const LobeView& view) const
    {
        return {view.normal, view.tangent, alpha_along, alpha};
    }
};

/// The facet that reflects one direction into another.
struct MirrorFacet {
    glm::vec3 half;
    float toward; ///< its cosine with both, from the length of their sum: the dot product may come
                  ///<   out below zero where they are nearly opposite

    MirrorFacet(const glm::vec3& in, const glm::vec3& out)
    {
        const glm::vec3 sum = in + out;
        const float length = glm::length(sum);
        half = sum / length;
        toward = length / 2;
    }
};

} // namespace hipmap
