#pragma once

#include "render/lobes/facets.h"
#include "render/lobes/fresnel.h"

namespace hipmap {

/// Reflection by GGX facets with Schlick's reflectance: metals and the coats of plastics,
/// docs/light_transport.md (16), (31).
struct MicrofacetReflection {
    static constexpr bool kFolds = true, kSeparable = false;
    Reflectance fresnel;
    Facets facets;
    Rgb multiple{0.0f}; ///< factor of multiple scattering between facets (multiple_scattering.h)

    Rgb eval(const LobeView& view, const glm::vec3& in) const;
    float pdf(const LobeView& view, const glm::vec3& in) const;
    /// Draws a direction.  No weight exceeds the reflectance of the facet drawn, except for
    /// multiple scattering.
    LobeSample sample(const LobeView& view, RandomSequence& random) const;
    Rgb albedo(const LobeView& view) const;
    bool is_directed() const { return facets.alpha_along > 0; }
};

} // namespace hipmap
