#pragma once

#include "common/math/sampling.h"
#include "render/shading/bsdf.h"

namespace hipmap {

/// The lobes of a surface that photons are gathered for, seen from one direction: the diffuse one,
/// sheen and a glossy reflection too rough to be followed.  What depends on that direction alone is
/// ready, so that a photon costs little.  Borrows the Bsdf.
class GatheredLobes {
  public:
    /// Normals: unit, on the side of `out`.  out: unit, away from the surface.
    GatheredLobes(const Bsdf& bsdf, const glm::vec3& shading_normal,
                  const glm::vec3& geometric_normal, const glm::vec3& out)
        : bsdf_(bsdf), normal_(shading_normal), geometric_(geometric_normal), out_(out),
          base_(bsdf.diffuse / kPi), burley_(bsdf.is_matt() && bsdf.burley_roughness >= 0)
    {
        if (!bsdf.is_matt())
            see_through_coats();
    }

    /// f(wi, wo), per steradian, with what is folded, docs/light_transport.md (19).  Of light from
    /// below, what passes diffusely.  in: unit, away from the surface.
    Rgb operator()(const glm::vec3& in) const
    {
        const float cosine = glm::dot(normal_, in);
        if (!(cosine > 0))
            return bsdf_.passes_diffusely() ? passed(in, -cosine) : Rgb(0);
        return burley_ ? base_ * burley_shape(bsdf_, normal_, in, out_) : of_all(in, cosine);
    }

    /// Of the diffuse lobe alone.  cosine: of `in` to the shading normal, above zero.
    Rgb diffuse(const glm::vec3& in, float cosine) const
    {
        const Rgb base =
            bsdf_.is_matt() ? base_ : base_ * through_coats(bsdf_, incidence(bsdf_, in, cosine));
        return base * diffuse_shape(bsdf_, normal_, in, out_);
    }

    /// That but for the factor of the diffuse lobe that depends on `in`.  Enough where all
    /// photons carry that factor, see docs/photon_maps.md (1).
    const Rgb& base() const { return base_; }

    /// The same of light from the other side, docs/light_transport.md (32).
    const Rgb& beyond() const { return beyond_; }

  private:
    void see_through_coats();

    /// cosine: of `in` to the shading normal's opposite.
    Rgb passed(const glm::vec3& in, float cosine) const;

    /// Of all that there is.
    Rgb of_all(const glm::vec3& in, float cosine) const;

    /// Of the facets of one reflection about its normal, with what is folded.
    Rgb facets(const Bsdf& bsdf, const glm::vec3& normal, const glm::vec3& in, float cosine) const;

    const Bsdf& bsdf_;
    glm::vec3 normal_, geometric_, out_;
    Rgb base_;         ///< D / pi * coat_half(out)
    Rgb beyond_{0.0f}; ///< the same of what passes diffusely
    bool burley_;      ///< the diffuse lobe is all, and not separable
};

/// f(wi, wo) of the fibres of a sheen, per steradian, as far as a clear coat lets it.  There must
/// be some; both directions above the surface.  docs/light_transport.md (28).
Rgb scattered_by_sheen(const Bsdf& bsdf, const glm::vec3& normal, const glm::vec3& in,
                       const glm::vec3& out);

/// f(wi, wo) of an opaque surface's facets, per steradian.  Both directions above the surface;
/// alpha above zero.  docs/light_transport.md (16).
Rgb reflected_by_facets(const Bsdf& bsdf, const glm::vec3& normal, const glm::vec3& in,
                        const glm::vec3& out);

} // namespace hipmap
