#pragma once

#include "render/maps/estimate.h"

#include <array>
#include <cstdint>

namespace hipmap {

/// Density of photon power within three radii of a point.
struct RadiusEstimates {
    std::array<Rgb, 3> irradiance{Rgb(0), Rgb(0), Rgb(0)}; ///< W/m2, by radius
    std::uint32_t photons = 0;                             ///< counted within the first radius
};

/// The irradiance at a point from all photons within each of the radii, docs/photon_maps.md (3):
///     E(R) = 1 / A(R) * sum of the powers within R
/// over the visible part of the disc, as estimate_irradiance does it; the same photons, so that the
/// estimates of one query differ by their radii alone.  query.radius is not used.
/// radii: scene units, descending, >= 0, finite; equal ones give equal estimates.  A radius of
/// zero, a face without a map, no photon, or a query that is not a number: zero, never NaN.
/// Thread-safe.  Cost: that of a search for as many photons.
RadiusEstimates estimate_within(const PhotonMaps& maps, const MapSurfaces& surfaces,
                                const PhotonQuery& query, const std::array<float, 3>& radii,
                                EstimateScratch& scratch);

} // namespace hipmap
