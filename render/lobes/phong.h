#pragma once

#include "render/lobes/lobe_view.h"

namespace hipmap {

/// Reflection by the normalised modified Phong model, docs/light_transport.md (35).
struct Phong {
    static constexpr bool kFolds = true, kSeparable = false;
    Rgb factor{0.0f};
    float exponent = 0.0f; ///< 0 or more

    Rgb eval(const LobeView& view, const glm::vec3& in) const;
    float pdf(const LobeView& view, const glm::vec3& in) const;
    LobeSample sample(const LobeView& view, RandomSequence& random) const;
    /// Returns about the share of light that the lobe scatters, for probabilities: exact for an
    /// exponent of 0 and for a very large one, never 0 unless the cosine is.
    Rgb albedo(const LobeView& view) const;
};

/// A Phong lobe whose exponent is too large to be told from a mirror.
struct PhongMirror {
    Rgb factor{0.0f};

    SpecularLobes specular(const LobeView& view) const { return {factor * view.cosine}; }
};

} // namespace hipmap
