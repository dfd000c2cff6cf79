#pragma once

#include "common/math/sampling.h"
#include "render/lobes/lobe_view.h"

namespace hipmap {

/// Fibres that stand on a surface (KHR_materials_sheen), docs/light_transport.md (28).
struct Sheen {
    static constexpr bool kFolds = false, kSeparable = false;
    Rgb color{0.0f};
    float alpha = 1.0f; ///< kLeastSheenAlpha (sheen_albedo.h) to 1

    Rgb eval(const LobeView& view, const glm::vec3& in) const;
    /// Returns the pdf of a direction that is uniform over the hemisphere.
    float pdf(const LobeView&, const glm::vec3&) const { return 1 / (2 * kPi); }
    LobeSample sample(const LobeView& view, RandomSequence& random) const;
    Rgb albedo(const LobeView& view) const;
};

} // namespace hipmap
