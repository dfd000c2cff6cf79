#pragma once

#include "render/maps/estimate.h"

namespace hipmap {

/// What a photon adds to the sum of an estimate: its power, weighed by the shape of the query's
/// diffuse lobe if that is not Lambert's.
Rgb gathered_power(const Photon& photon, const PhotonQuery& query);

/// The same by the cosine between the photon's face and the query's, docs/photon_maps.md (4).
Rgb projected_power(const Photon& photon, const PhotonQuery& query, const MapSurfaces& surfaces);

/// Zero where the area is not above zero or the quotient not finite.
Rgb per_area(const Rgb& power, double area);

/// pi r^2, square scene units.
double disc_area(float radius);

/// Points scratch.disc past the boundaries of the query's map within the radius (> 0, finite);
/// without any near, scratch.segments is left empty.
void look_around(const MapSurfaces& surfaces, const PhotonQuery& query, float radius,
                 EstimateScratch& scratch);

} // namespace hipmap
