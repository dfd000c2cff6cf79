#pragma once

#include "common/math/random.h"

#include <glm/glm.hpp>

namespace hipmap {

/// How the radiance of an area light depends on direction: as that of a softbox with a grid,
/// docs/light_transport.md (47).  Without values it is the same in all directions.
struct Spread {
    float per_tangent =
        0.0f;              ///< 1 / tan of the angle from the axis where light ends; 0: 90 degrees
    float on_axis = 1.0f;  ///< radiance along the axis, as a multiple of an even light's
    float cos_edge = 0.0f; ///< cosine of that angle
};

/// half_angle: from the axis to where light ends, radians, above 0 and up to pi/2.
Spread make_spread(double half_angle);

/// Returns the radiance at an angle from the axis, as a multiple of that of an even light of the
/// same power.  cosine: of the angle, above 0.
float radiance_share(const Spread& spread, float cosine);

/// Draws a direction about +z with a pdf in proportion to radiance times cosine.
glm::vec3 sample_direction(const Spread& spread, RandomSequence& random);

} // namespace hipmap
