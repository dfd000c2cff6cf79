#pragma once

#include "render/lobes/facets.h"

namespace hipmap {

/// Reflection and transmission by GGX facets of a dielectric: rough glass,
/// docs/light_transport.md (16), (17).  A thin wall is crossed without a bend.
struct RoughDielectric {
    static constexpr bool kFolds = true, kSeparable = false, kTransmits = true;
    float share = 1.0f;   ///< of the surface that is this dielectric
    Rgb tint{1.0f};       ///< transmitted at each crossing
    Rgb reflection{1.0f}; ///< scale of the Fresnel reflection (KHR_materials_specular)
    Facets facets;

    Rgb eval(const LobeView& view, const glm::vec3& in) const;
    float pdf(const LobeView& view, const glm::vec3& in) const;
    /// Draws a direction.  No weight exceeds the sum of what the facet drawn reflects and
    /// transmits.
    LobeSample sample(const LobeView& view, RandomSequence& random) const;
    /// Returns the albedo for probabilities, by the Fresnel reflectance at the shading normal.
    Rgb albedo(const LobeView& view) const;
    bool is_directed() const { return facets.alpha_along > 0; }
};

} // namespace hipmap
