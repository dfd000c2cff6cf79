#pragma once

#include "common/math/sampling.h"
#include "render/shading/interaction.h"
#include "render/shading/lobe_batch.h"

namespace hipmap {

/// The gathered or the followed lobes of a surface that has some, seen from one direction, as
/// photons need them.
/// What depends on that direction alone is computed once, so that a photon costs little.  Borrows
/// the interaction.
class PhotonLobes {
  public:
    explicit PhotonLobes(const Interaction& at, Lobes handled = Lobes::gathered)
        : at_(at), lobes_{at.bsdf(), handled, view_of(at, Depth::diffuse), at.normal, {}},
          base_(lobes_.bsdf.diffuse * (1 / kPi))
    {
        if (!lobes_.bsdf.is_diffuse)
            look_through_layers();
    }

    /// Returns f(wi, wo), per steradian, relative to the cosine of `in` to the shading normal, with
    /// folded light, docs/light_transport.md (19).  For light from the other side, gathered lobes
    /// have the diffuse transmission, others nothing.  in: unit, away from the surface.
    Rgb operator()(const glm::vec3& in) const
    {
        const Bsdf& bsdf = lobes_.bsdf;
        const float cosine = glm::dot(lobes_.view.normal, in);
        if (!(cosine > 0))
            return bsdf.transmits_diffusely && lobes_.handled == Lobes::gathered
                       ? transmitted(in, -cosine)
                       : Rgb(0);
        return bsdf.is_diffuse ? eval(bsdf.all[0].lobe, lobes_.view, in) : of_all(in, cosine);
    }

    /// Writes the value of the lobes for each of the first `count` directions, 1 to kBatch: several
    /// at a time where weigh_batch can, with the bits that one by one would give.
    void weigh(const DirectionBatch& in, std::size_t count, RgbBatch& out) const;

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
    SeenLobes lobes_;
    Rgb base_, behind_{0.0f};
};

} // namespace hipmap
