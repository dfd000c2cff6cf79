#pragma once

#include "render/maps/radius_field.h"
#include "render/photons/trace_photons.h"

#include <cstdint>

namespace hipmap {

/// The radii of the first pass, from pilot photons that are never summed: an estimate must not
/// depend on the photons that are summed within its radius.  docs/photon_maps.md (10).
struct FirstRadii {
    RadiusField caustic, global, indirect;
};

/// Returns the query of photons where one lies.
PhotonQuery query_at(const Photon& photon, const MapSurfaces& surfaces);

/// Returns how many of the gather rays of a pixel count in gather_weight: all photons that one
/// reads share its direction, so that together they tell less than as many photons that came by
/// ways of their own.  docs/light_transport.md (42).  shrink: radius of the pass over the first
/// radius.
float counted_rays(float samples, float shrink);

/// Returns the weight of final gathering against direct photons.  Light that goes from a diffuse
/// surface at y to the diffuse surface at x is found in two ways: by the final-gather ray from x
/// that reads a map at y, and by the photon that continued from y to x.  Both are weighted by how
/// much each finds, docs/light_transport.md (21); the weight of the first is 1 if there is no
/// second (radius_at_x zero or not finite).  rays: by counted_rays.
float gather_weight(float radius_at_y, float radius_at_x, float rays);

/// Returns the bounced photons with their powers multiplied by 1 - gather_weight.  In parallel.
std::vector<Photon> weigh_bounces(const TracedPhotons& traced, const FirstRadii& first,
                                  const MapSurfaces& surfaces, float rays);

} // namespace hipmap
