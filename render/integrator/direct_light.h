#pragma once

#include "common/math/random.h"
#include "render/shading/interaction.h"

namespace hipmap {

/// Light that reaches the diffuse lobe of a surface straight from the lights, by shadow rays:
///     integral over wi of L(wi) coat_half(wi) cos(wi)                docs/light_transport.md (11)
/// in W/m2, an unbiased estimate from one sample of each punctual light, one of the emissive faces
/// and one of the hemisphere, the last two combined by the balance heuristic (Veach 1997).
/// Light on the other side than `at` was seen from does not count.  Thread-safe.
Rgb direct_irradiance(const RenderScene& scene, const Interaction& at, RandomSequence& random);

} // namespace hipmap
