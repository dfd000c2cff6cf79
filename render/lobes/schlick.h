#pragma once

#include "render/lobes/fresnel.h"
#include "render/lobes/lobe_view.h"

namespace hipmap {

/// The shares of a layer of Schlick's model (1994), without its reflectance; they sum to one.
/// docs/light_transport.md (36).
struct SchlickShares {
    float even = 0.0f;   ///< a: as a diffuse surface
    float spread = 0.0f; ///< b: about the mirror direction
    float mirror = 0.0f; ///< c
};

/// Returns the shares.  roughness: Schlick's r, 0 to 1.
SchlickShares schlick_shares(float roughness);

/// The least isotropy: below it, light spreads as at it.
inline constexpr float kLeastIsotropy = 0.01f;

/// A layer of Schlick's model without its mirror's share and without the diffuse part that is the
/// same for all directions.
struct Schlick {
    static constexpr bool kFolds = true, kSeparable = false;
    Reflectance fresnel;
    float alpha = 1.0f;    ///< square root of the roughness, above zero
    float isotropy = 1.0f; ///< his p, kLeastIsotropy to 1; below 1: grooves across the tangent

    Rgb eval(const LobeView& view, const glm::vec3& in) const;
    float pdf(const LobeView& view, const glm::vec3& in) const;
    LobeSample sample(const LobeView& view, RandomSequence& random) const;
    Rgb albedo(const LobeView& view) const;
    bool is_directed() const { return isotropy < 1; }
};

} // namespace hipmap
