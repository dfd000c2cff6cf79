#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace hipmap {

// The lobe of the normalised modified Phong model, docs/light_transport.md (35).  All directions
// are unit and lie above the surface; image: the mirror image, about the shading normal, of the one
// that light goes to (or comes from: it is the same both ways).  exponent: 0 or more.

/// The roughness at which facets (16) spread light about as widely near the middle of the lobe;
/// 1 for an exponent of 0.
float phong_roughness(float exponent);

/// f for a specular factor of 1, per steradian.
float phong_lobe(const glm::vec3& in, const glm::vec3& image, float exponent);

/// Chance per steradian that `draw_phong` draws `in`.
float phong_density(const glm::vec3& in, const glm::vec3& image, float exponent);

/// Drawn about the image: it may lie below the surface.  u: [0, 1)^2.
glm::vec3 draw_phong(const glm::vec3& image, float exponent, const glm::vec2& u);

/// About the share of light along one direction that the lobe sends on, for chances: exact for an
/// exponent of 0 and for a very large one, never 0 unless the cosine is.
float phong_albedo(float cosine, float exponent);

} // namespace hipmap
