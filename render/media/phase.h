#pragma once

#include "common/scene/medium.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace hipmap {

/// Returns the phase function, per steradian; its integral over the sphere is 1.  cosine: between
/// the directions in which light travels before and after.  docs/media.md (2).
float phase_value(const PhaseFunction& phase, float cosine);

/// Draws the direction after a scattering, with pdf `phase_value`.  travel: unit.  u: [0, 1)^2.
glm::vec3 sample_phase(const PhaseFunction& phase, const glm::vec3& travel, const glm::vec2& u);

} // namespace hipmap
