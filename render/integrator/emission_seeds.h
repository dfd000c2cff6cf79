#pragma once

#include "render/integrator/importons.h"
#include "render/photons/guide_learner.h"

#include <vector>

namespace hipmap {

/// Returns starts of light paths from suns and environments to where photons are asked for, found
/// by rays from there that leave the scene: paths by power find a small part of a large scene too
/// rarely to learn from.  Where there are no importons of the indirect map, as of integrator
/// direct, none lies where gather rays end, so that paths which come by a bounce are looked for
/// too.  In parallel; the same at any thread count.  No light from beyond the scene: none.
/// docs/light_transport.md (41).
std::vector<EmissionSeed> emission_seeds(const RenderScene& scene, const Importons& importons,
                                         std::uint64_t seed);

} // namespace hipmap
