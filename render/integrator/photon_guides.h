#pragma once

#include "render/integrator/coarse_image.h"
#include "render/integrator/importons.h"
#include "render/photons/guide_learner.h"

#include <cstdint>
#include <memory>
#include <span>

namespace hipmap {

/// Learns where light paths should start, from photons of pilots, the first of which start by
/// power, or near the seeds. photons: of a pass, its number that of the first pilot, from which the
/// others count down. Null: paths by power are about as good, or there are photons in media, whose
/// worth is not known.  pilots: a stop ends the rounds.  The result is the same at any thread
/// count.  docs/light_transport.md (41).
std::shared_ptr<const PhotonGuides>
learn_guides(const MappedScene& mapped, const PhotonOptions& photons, const PhotonWorth& worth,
             std::span<const EmissionSeed> seeds, const PilotControl& pilots);

/// Returns a checksum of the guides, by which states know them.
std::uint64_t checksum(const PhotonGuides& guides);

} // namespace hipmap
