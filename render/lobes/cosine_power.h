#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace hipmap {

/// Lobes that fall off as a power of the cosine of the angle to an axis, as those of Phong and
/// Lafortune do.  All directions are unit, the exponent is 0 or more.

/// Returns the power of the cosine of the angle between two directions; 0 beyond a right angle.
float cosine_power(const glm::vec3& a, const glm::vec3& b, float exponent);

/// Draws a direction about the axis with pdf (exponent + 1) / (2 pi) * cosine_power.  u: [0, 1)^2.
glm::vec3 sample_cosine_power(const glm::vec3& axis, float exponent, const glm::vec2& u);

/// Returns the roughness at which facets (16) spread light about as widely near the middle of the
/// lobe; 1 for an exponent of 0.  docs/light_transport.md (35).
float cosine_power_roughness(float exponent);

} // namespace hipmap
