#pragma once

#include "common/scene/medium.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace hipmap {

/// Per steradian; its integral over the sphere is 1.  cosine: between the directions in which light
/// travels before and after.  docs/media.md (2).
float phase_value(const PhaseFunction& phase, float cosine);

/// A direction to go on in, drawn with the density `phase_value`.  travel: unit.  u: [0, 1)^2.
glm::vec3 sample_phase(const PhaseFunction& phase, const glm::vec3& travel, const glm::vec2& u);

} // namespace hipmap
