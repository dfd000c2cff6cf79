#pragma once

#include "render/integrator/placed_guides.h"

#include <cstdint>
#include <span>

namespace hipmap {

/// Learns where the environments are seen from the surfaces that the image gathers at, by rays from
/// importons there.  Places that see little of the sky get directions by which it is sampled;
/// elsewhere lobes and the environments' own samples are as good.  No environment: none.  In
/// parallel; the same at any thread count.  docs/light_transport.md (49).
PlacedGuides learn_sky(const RenderScene& scene, std::span<const Photon> from, std::uint64_t seed);

} // namespace hipmap
