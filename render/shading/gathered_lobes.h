#pragma once

#include "render/shading/bsdf.h"

namespace hipmap {

/// The lobes of a surface that photons are gathered for, seen from one direction: the diffuse one
/// and a glossy reflection too rough to be followed.  What depends on that direction alone is
/// ready, so that a photon costs little.  Borrows the Bsdf.
class GatheredLobes {
  public:
    /// Normals: unit, on the side of `out`.  out: unit, away from the surface.
    GatheredLobes(const Bsdf& bsdf, const glm::vec3& shading_normal,
                  const glm::vec3& geometric_normal, const glm::vec3& out);

    /// f(wi, wo), per steradian, with what is folded, docs/light_transport.md (19); zero for light
    /// from below.  in: unit, away from the surface.
    Rgb operator()(const glm::vec3& in) const;

    /// Of the diffuse lobe alone.  cosine: of `in` to the shading normal, above zero.
    Rgb diffuse(const glm::vec3& in, float cosine) const;

    /// That but for the factor of the diffuse lobe that depends on `in`.  Enough where all
    /// photons carry that factor, see docs/photon_maps.md (1).
    const Rgb& base() const { return base_; }

  private:
    /// Of the facets of one reflection, with what is folded.
    Rgb facets(const Bsdf& bsdf, const glm::vec3& in, float cosine) const;

    const Bsdf& bsdf_;
    glm::vec3 normal_, geometric_, out_;
    float cosine_; ///< of `out`
    Rgb base_;     ///< D / pi * coat_half(out)
};

/// f(wi, wo) of an opaque surface's facets, per steradian.  Both directions above the surface;
/// alpha above zero.  docs/light_transport.md (16).
Rgb reflected_by_facets(const Bsdf& bsdf, const glm::vec3& normal, const glm::vec3& in,
                        const glm::vec3& out);

} // namespace hipmap
