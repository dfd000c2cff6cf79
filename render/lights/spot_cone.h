#pragma once

#include "common/math/random.h"
#include "common/scene/spot_falloff.h"

#include <glm/glm.hpp>

namespace hipmap {

/// The fall-off of a spot light's intensity, docs/light_transport.md (6), (39).
struct SpotCone {
    glm::vec3 direction{0, 0, -1}; ///< unit, along its axis
    float cos_inner = 1.0f;        ///< where the rim begins, cos_inner > cos_outer
    float cos_outer = 0.0f;        ///< no light beyond; 0 or more for smooth_cosine
    SpotFalloff falloff = SpotFalloff::gltf;
};

/// Returns the share of the full intensity along `direction` (unit, away from the light).
float falloff(const SpotCone& cone, const glm::vec3& direction);

/// Returns the integral of the fall-off over directions, docs/light_transport.md (7), (39).
float falloff_integral(const SpotCone& cone);

/// Draws a direction with a pdf in proportion to the fall-off.
glm::vec3 sample_direction(const SpotCone& cone, RandomSequence& random);

} // namespace hipmap
