#pragma once

#include "common/math/random.h"
#include "render/shading/interaction.h"

namespace hipmap {

/// What the diffuse lobe makes of light from a direction: coat_half(wi) cos(wi) and the lobe's
/// shape; zero if the direction is not above the surface.
Rgb receive(const Interaction& at, const glm::vec3& direction);

/// Chance per solid angle, at a point `distance` away, that sampling the emissive faces finds
/// `on_light`.  direction: between the two, unit.
float emissive_density(const RenderScene& scene, const SurfacePoint& on_light,
                       const glm::vec3& direction, float distance);

/// The punctual lights' share of `direct_irradiance`.
Rgb punctual_irradiance(const RenderScene& scene, const Interaction& at, RandomSequence& random);

/// The emissive faces' share, by one point on them, weighed by the balance heuristic against a ray
/// by the cosine of the lobe that is sent with chance `ray_chance`.  There must be an emissive
/// face.
Rgb emissive_irradiance(const RenderScene& scene, const Interaction& at, float ray_chance,
                        RandomSequence& random);

/// Light that reaches the diffuse lobe of a surface straight from the lights, by shadow rays:
///     integral over wi of L(wi) coat_half(wi) cos(wi)                docs/light_transport.md (11)
/// in W/m2, an unbiased estimate from one sample of each punctual light, one of the emissive faces
/// and one of the hemisphere, the last two combined by the balance heuristic (Veach 1997).
/// Light on the other side than `at` was seen from does not count.  Thread-safe.
Rgb direct_irradiance(const RenderScene& scene, const Interaction& at, RandomSequence& random);

} // namespace hipmap
