#pragma once

#include "common/math/sampling.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>

namespace hipmap {

// The height of a cone is 1 - cos of its half angle, which keeps its digits in thin cones.

/// Returns the pdf per solid angle of a direction drawn evenly from a cone.
inline float cone_pdf(float height)
{
    return 1 / (2 * kPi * height);
}

/// Returns a unit vector whose height over the xy plane is `below` less than 1.
inline glm::vec3 direction_below_pole(float below, float u)
{
    const float sine = std::sqrt(below * (2 - below)), phi = 2 * kPi * u;
    return {sine * std::cos(phi), sine * std::sin(phi), 1 - below};
}

/// Returns the u of [0, 1)^2 from which direction_below_pole(height * u.x, u.y) makes a unit vector
/// of a cone about +z.
inline glm::vec2 cone_sample_of(float height, const glm::vec3& direction)
{
    const glm::vec2 across(direction);
    const float turn = std::atan2(across.y, across.x) / (2 * kPi);
    const float below = glm::dot(across, across) / (1 + direction.z); // steadier than 1 - z
    return {std::min(below / height, 0x1.fffffep-1f), turn < 0 ? turn + 1 : turn};
}

} // namespace hipmap
