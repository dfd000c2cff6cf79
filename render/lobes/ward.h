#pragma once

#include "render/lobes/lobe_view.h"

namespace hipmap {

/// Reflection by Ward's anisotropic model in its bounded form, docs/light_transport.md (45).
struct Ward {
    static constexpr bool kFolds = true, kSeparable = false;
    Rgb factor{0.0f};
    glm::vec2 slopes{0.5f}; ///< of its facets along the tangent and across it, above 0, at most 1

    Rgb eval(const LobeView& view, const glm::vec3& in) const;
    float pdf(const LobeView& view, const glm::vec3& in) const;
    LobeSample sample(const LobeView& view, RandomSequence& random) const;
    /// Returns about the share of light that the lobe scatters, for probabilities: exact at normal
    /// incidence if the slopes are equal, at most 1.7 times the share elsewhere.
    Rgb albedo(const LobeView& view) const;
    bool is_directed() const { return slopes.x != slopes.y; }
};

/// Returns the slope of the isotropic lobe that peaks as high as the lobe of two slopes.
float mean_ward_slope(const glm::vec2& slopes);

} // namespace hipmap
