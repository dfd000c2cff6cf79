#pragma once

#include "common/math/sampling.h"
#include "render/shading/interaction.h"

#include <array>

namespace hipmap {

/// The gathered or the followed lobes of a surface seen from one direction, as photons need them.
/// What depends on that direction alone is computed once, so that a photon costs little.  Borrows
/// the interaction.
class PhotonLobes {
  public:
    explicit PhotonLobes(const Interaction& at, Lobes handled = Lobes::gathered)
        : at_(at), bsdf_(at.bsdf()), handled_(handled), view_(view_of(at, Depth::diffuse)),
          base_(bsdf_.diffuse * (1 / kPi))
    {
        if (!bsdf_.is_diffuse)
            look_through_layers();
    }

    /// Returns f(wi, wo), per steradian, relative to the cosine of `in` to the shading normal, with
    /// folded light, docs/light_transport.md (19).  For light from the other side, gathered lobes
    /// have the diffuse transmission, others nothing.  in: unit, away from the surface.
    Rgb operator()(const glm::vec3& in) const
    {
        const float cosine = glm::dot(view_.normal, in);
        if (!(cosine > 0))
            return bsdf_.transmits_diffusely && handled_ == Lobes::gathered
                       ? transmitted(in, -cosine)
                       : Rgb(0);
        return bsdf_.is_diffuse ? eval(bsdf_.all[0].lobe, view_, in) : of_all(in, cosine);
    }

    /// Returns the factor of f that depends on no photon: enough where all gathered lobes of the
    /// scene are separable, and photons carry the factor of `in`, docs/photon_maps.md (1).
    const Rgb& base() const { return base_; }

    /// Returns the factor of f for light from the other side that depends on no photon,
    /// docs/light_transport.md (32).
    const Rgb& behind() const { return behind_; }

  private:
    void look_through_layers();
    Rgb of_all(const glm::vec3& in, float cosine) const;
    Rgb reflected(const PlacedLobe& lobe, const glm::vec3& in, float cosine) const;

    /// Returns f for light from the other side.  cosine: of `in` to the shading normal's opposite.
    Rgb transmitted(const glm::vec3& in, float cosine) const;

    const Interaction& at_;
    const Bsdf& bsdf_;
    const Lobes handled_;
    LobeView view_; ///< of all but the clear coat
    Rgb base_, behind_{0.0f};
    std::array<Rgb, 4> seen_; ///< [Depth] what layers leave on the way to `back`
};

} // namespace hipmap
