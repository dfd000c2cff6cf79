#pragma once

#include "render/lobes/lobe_view.h"

namespace hipmap {

/// Reflection by one lobe of Lafortune's model, docs/light_transport.md (46).
struct Lafortune {
    static constexpr bool kFolds = true, kSeparable = false;
    Rgb factor{0.0f};
    float exponent = 0.0f; ///< 0 or more
    /// Factors of a direction's parts along the tangent, across it and along the normal: -1 to 1,
    /// the last 0 or more.  (-1, -1, 1) is Phong's lobe.
    glm::vec3 coefficients{-1, -1, 1};

    Rgb eval(const LobeView& view, const glm::vec3& in) const;
    float pdf(const LobeView& view, const glm::vec3& in) const;
    LobeSample sample(const LobeView& view, RandomSequence& random) const;
    /// Returns about the share of light that the lobe scatters, for probabilities: exact for an
    /// exponent of 0 and for a very large one.
    Rgb albedo(const LobeView& view) const;
    bool is_directed() const { return coefficients.x != coefficients.y; }
};

} // namespace hipmap
