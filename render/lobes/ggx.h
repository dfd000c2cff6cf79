#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace hipmap {

/// Facets with the GGX distribution (Trowbridge and Reitz 1975; Walter et al. 2007) and Smith's
/// height-correlated masking (Heitz 2014), docs/light_transport.md (16) and (17).  All directions
/// are unit, alpha is above zero, cosines are those to the shading normal.

/// Returns s(c) = sqrt(alpha^2 + (1 - alpha^2) c^2), from which masking is computed.
float ggx_slope(float cosine, float alpha);

/// Returns D(h), per solid angle.  normal, half: unit.
float ggx_distribution(const glm::vec3& normal, const glm::vec3& half, float alpha);

/// Returns G2 / (4 cos_in cos_out), finite unless both cosines are zero.
float ggx_visibility(float cos_in, float cos_out, float alpha);

/// Returns G2 / G1(out), in [0, 1]: the share that masking leaves of light reflected by a facet
/// drawn by `sample_facet`.  cos_in above zero.
float ggx_shadowing(float cos_in, float cos_out, float alpha);

/// Returns the pdf of the direction that a facet drawn by `sample_facet` reflects `out` into, by
/// its half vector `half`: ggx_facet_pdf over 4 dot(out, half), which cancels out.
float ggx_reflected_pdf(const glm::vec3& normal, const glm::vec3& out, const glm::vec3& half,
                        float alpha);

/// Returns the pdf with which `sample_facet` draws `half`; 0 for facets turned away.
float ggx_facet_pdf(const glm::vec3& normal, const glm::vec3& out, const glm::vec3& half,
                    float alpha);

/// Draws the normal of a facet, in proportion to what is visible from `out` (above the surface).
/// u: [0, 1)^2. Source: Heitz 2018, drawn as in Dupuy and Benyoub 2023.
glm::vec3 sample_facet(const glm::vec3& normal, const glm::vec3& out, float alpha,
                       const glm::vec2& u);

} // namespace hipmap
