#pragma once

#include <glm/vec3.hpp>

namespace hipmap {

// What a layer of Schlick's model (1994) does with light, its reflectance apart,
// docs/light_transport.md (36).  roughness: his r, 0 to 1.

/// How it shares light out; they sum to one.
struct SchlickShares {
    float even = 0.0f;   ///< a: as a matt surface does
    float spread = 0.0f; ///< b: about the mirror direction
    float mirror = 0.0f; ///< c
};

SchlickShares schlick_shares(float roughness);

/// Below it, light spreads as at it.
inline constexpr float kLeastIsotropy = 0.01f;

/// A surface with grooves across `along`.
struct SchlickLayer {
    glm::vec3 normal; ///< shading
    glm::vec3 along;  ///< unit, across the normal; any where isotropy is 1
    float alpha;      ///< square root of the roughness, above zero
    float isotropy;   ///< his p, kLeastIsotropy to 1

    /// Of what is spread: G(v) G(v') Z(t) A(w) / (4 pi v v').  half: between both directions, which
    /// lie above the surface; all unit.
    float spread(const glm::vec3& in, const glm::vec3& out, const glm::vec3& half) const;
};

} // namespace hipmap
