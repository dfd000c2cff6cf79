#pragma once

#include "common/math/rgb.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <memory>
#include <vector>

namespace hipmap {

enum class PhaseKind : std::uint8_t { isotropic, henyey_greenstein, schlick };

/// The angular distribution of light that a medium scatters, docs/media.md (2).
struct PhaseFunction {
    PhaseKind kind = PhaseKind::isotropic;
    float g = 0.0f; ///< mean cosine, above -1 and below 1; of Schlick's that of the Henyey and
                    ///<   Greenstein function it stands for
};

/// The density of a medium: a factor of its coefficients at the nodes of a grid that fills the box
/// of its mesh, docs/media.md (11).
struct DensityGrid {
    glm::uvec3 nodes{2};       ///< along x, y and z of the world, at least 2
    std::vector<float> values; ///< [x * y * z], x fastest; finite, not negative
};

/// A medium that fills a closed mesh, or surrounds the scene.
struct Medium {
    Rgb absorption{0.0f}; ///< per scene unit
    Rgb scattering{0.0f}; ///< per scene unit
    Rgb emission{0.0f};   ///< radiance gained per scene unit, W/(m2 sr)
    PhaseFunction phase;
    std::shared_ptr<const DensityGrid> density; ///< null: 1 everywhere

    /// Returns the extinction coefficient per scene unit where the density is 1.
    Rgb extinction() const { return absorption + scattering; }
    bool scatters() const { return !is_black(scattering); }
    bool emits() const { return !is_black(emission); }
    bool is_clear() const { return is_black(extinction()) && !emits(); }
};

} // namespace hipmap
