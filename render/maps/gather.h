#pragma once

#include "render/maps/estimate.h"

namespace hipmap {

/// A photon as an estimate reads it.
struct MetPhoton {
    const PhotonMap& map;
    std::uint32_t slot;
};

/// Returns the photon's power in units of the maps' scale, weighted by the query's lobes, which it
/// must name.
glm::dvec3 power_in_lobes(const MetPhoton& photon, const PhotonQuery& query);

/// Returns what a photon adds to the sum of an estimate: its power, weighted by the query's lobes
/// if it names any.
inline glm::dvec3 gathered_power(const MetPhoton& photon, const PhotonQuery& query)
{
    if (query.lobes != nullptr)
        return power_in_lobes(photon, query);
    return photon.map.powers.of(photon.slot);
}

/// Returns the gathered power times the cosine between the photon's face and the query's,
/// docs/photon_maps.md (4).
glm::dvec3 projected_power(const MetPhoton& photon, const PhotonQuery& query,
                           const MapSurfaces& surfaces);

/// Returns whether the face of a photon looks to the same side as the query's, docs/visible_area.md
/// (A8).
bool is_on_side(const MetPhoton& photon, const PhotonQuery& query, const MapSurfaces& surfaces);

/// Converts a sum in units of the scale into W/m2.  Zero where the area is not above zero or the
/// quotient is not finite.
Rgb per_area(const PowerScale& scale, const glm::dvec3& sum, double area);

/// Returns pi r^2, square scene units.
double disc_area(float radius);

/// Returns the area of the surface within a radius (>= 0) of a point on a face, where no boundary
/// is near: pi r^2, or less on a map that is smaller, docs/visible_area.md (A9); square scene
/// units.
double open_area(const MapSurfaces& surfaces, FaceId face, float radius);

/// Sets up scratch.disc with the boundaries of the query's map within the radius (> 0, finite);
/// scratch.segments stays empty if none is near.  Returns the radius out to which the disc may be
/// used: the given one, or less where the boundary is too dense for it; 0: none.
float look_around(const MapSurfaces& surfaces, const PhotonQuery& query, float radius,
                  EstimateScratch& scratch);

} // namespace hipmap
