#pragma once

#include "common/math/rgb.h"

#include <cstdint>

namespace hipmap {

enum class PhaseKind : std::uint8_t { isotropic, henyey_greenstein, schlick };

/// How a medium spreads the light that it scatters, docs/media.md (2).
struct PhaseFunction {
    PhaseKind kind = PhaseKind::isotropic;
    float g = 0.0f; ///< mean cosine, above -1 and below 1; of Schlick's that of the Henyey and
                    ///<   Greenstein function it stands for
};

/// What fills a closed mesh, or surrounds the scene: the same everywhere.
struct Medium {
    Rgb absorption{0.0f}; ///< per scene unit
    Rgb scattering{0.0f}; ///< per scene unit
    Rgb emission{0.0f};   ///< radiance gained per scene unit, W/(m2 sr)
    PhaseFunction phase;

    /// What a ray loses per scene unit.
    Rgb extinction() const { return absorption + scattering; }
    bool scatters() const { return !is_black(scattering); }
    bool glows() const { return !is_black(emission); }
    bool is_clear() const { return is_black(extinction()) && !glows(); }
};

} // namespace hipmap
