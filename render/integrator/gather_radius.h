#pragma once

#include "render/maps/estimate.h"
#include "render/photons/trace_photons.h"

#include <cmath>
#include <cstdint>

namespace hipmap {

/// Photons of the pilot, never summed.
struct PilotMaps {
    PhotonMaps caustic, global, indirect;
};

/// Radius of the first pass at a point, scene units: where the k-th photon of the pilot's map is,
/// at most the one within which k would lie were the map's photons spread evenly over it.  It
/// depends on the point alone, never on the photons that are summed within it.
/// docs/photon_maps.md (10).  Infinite for a face without a map.
float first_radius(const PhotonMaps& pilot, const MapSurfaces& surfaces, PhotonQuery query,
                   SearchScratch& scratch);

/// Light that goes from a diffuse surface at y to the diffuse surface at x is found in two ways: by
/// the gather ray from x that reads a map at y, and by the photon that went on from y to x.  Both
/// are weighed by what photons each needs, docs/light_transport.md (21).  The weight of the first;
/// 1 if there is no second (radius_at_x zero or not finite).
float gather_weight(float radius_at_y, float radius_at_x);

/// The photons of the second way, with their powers times 1 - gather_weight.  In parallel.
std::vector<Photon> weigh_bounces(const TracedPhotons& traced, const PilotMaps& pilot,
                                  const MapSurfaces& surfaces);

} // namespace hipmap
