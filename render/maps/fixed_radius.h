#pragma once

#include "render/maps/estimate.h"

#include <array>
#include <cstdint>

namespace hipmap {

/// The density of photon power within three radii of a point.
struct RadiusEstimates {
    std::array<Rgb, 3> irradiance{Rgb(0), Rgb(0), Rgb(0)}; ///< W/m2, by radius
    std::uint32_t photons = 0;                             ///< counted within the first radius
};

/// Returns three radii with the ratios of `radii` and `seen` as the first, so that the differences
/// of their estimates still measure the bias of the first.  seen: at most radii[0].
std::array<float, 3> narrowed(const std::array<float, 3>& radii, float seen);

/// An estimate from the photons of one map within three radii.
struct RadiusQuery {
    const PowerScale& scale; ///< of the map's photons
    const MapSurfaces& surfaces;
    const PhotonQuery& query;
    std::array<float, 3> radii; ///< scene units, descending
};

/// Sums of powers by radius: red, green, blue, 0.
struct alignas(32) SumsByRadius {
    double of[3][4] = {};

    glm::dvec3 at(std::size_t r) const { return {of[r][0], of[r][1], of[r][2]}; }
};

/// Adds 1 to kBatch photons of a map, in their order, to the sums of the radii that they lie
/// within.  tilted: each is weighted by the cosine between its face and the query's,
/// docs/photon_maps.md (4).
void add_photons(const PhotonMap& map, std::span<const std::uint32_t> slots,
                 const RadiusQuery& wanted, bool tilted, SumsByRadius& sums);

/// Estimates irradiance from those photons of a list that lie in the visible disc of the query.
/// found: all photons within the first radius.  scratch.disc: as look_around has set it.
/// wanted.radii: narrowed to what look_around has found visible.
RadiusEstimates estimate_from_list(const FoundPhotons& found, const RadiusQuery& wanted,
                                   const EstimateScratch& scratch);

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
