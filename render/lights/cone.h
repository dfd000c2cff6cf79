#pragma once

#include "common/math/sampling.h"

#include <glm/glm.hpp>

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

} // namespace hipmap
