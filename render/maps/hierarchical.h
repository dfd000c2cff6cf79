#pragma once

#include "render/maps/photon_maps.h"

#include <string>

namespace hipmap {

/// Plans the local and the group tier of mode hierarchical from the shared maps,
/// docs/photon_maps.md (8), and keeps the maps of those that are used.  Same maps, same plan, at
/// any thread count. Cost: a pass over the photons, and searches for some 1000 of them.  No
/// photons: no tiers.
void build_tiers(PhotonMaps& maps, const TriangleMesh& mesh, const Partition& partition);

/// Why a tier is used or not, in a few words with the figures.
std::string describe_plan(const TierPlan& plan);

} // namespace hipmap
