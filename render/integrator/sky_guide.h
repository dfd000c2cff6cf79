#pragma once

#include "render/integrator/importons.h"
#include "render/integrator/placed_guides.h"

#include <cstdint>

namespace hipmap {

/// Learns where the environments are seen from the surfaces that the image gathers at, by rays from
/// importons.  Places that see little of the sky get directions by which it is sampled; elsewhere
/// lobes and the environments' own samples are as good.  No environment: none.  In parallel; the
/// same at any thread count.  docs/light_transport.md (49).
PlacedGuides learn_sky(const RenderScene& scene, const Importons& importons, std::uint64_t seed);

} // namespace hipmap
