#pragma once

#include "render/dissertation/dissertation.h"

#include <optional>
#include <vector>

namespace hipmap {

struct IrradianceOptions {
    std::uint32_t photons_each = 4; ///< one photon of so many gets an estimate; >= 1
    bool bounded = false; ///< nothing farther than even_radius counts, as for caustic photons
};

/// The irradiance at some photons of each map, estimated beforehand for final-gather rays, which
/// need it in many places and less exactly (Christensen 1999, "Faster photon map global
/// illumination"), docs/photon_maps.md.  Read-only once built: any number of threads may use it.
struct PhotonIrradiance {
    /// The estimates of one map.
    struct Map {
        WideTree tree;                  ///< of the photons that have an estimate
        std::vector<Rgb> irradiance;    ///< [n] by slot, W/m2
        std::vector<glm::vec3> normals; ///< [n] by slot, unit, of the side that the light fell on
    };
    std::vector<Map> maps; ///< parallel to DissertationMaps::shared.maps
};

/// Estimates the irradiance (Lambert's) at every n-th photon of each map, in parallel.  Same maps,
/// same numbers, at any thread count.  No photons: no maps.  Cost: one estimate and 40 bytes for
/// each of these photons.
PhotonIrradiance estimate_at_photons(const DissertationMaps& maps, const MapSurfaces& surfaces,
                                     const IrradianceOptions& options);

/// Returns the irradiance at the nearest of the chosen photons in the query's map whose surface
/// faces the same way: their normals are less than 45 degrees from the query's.  Nothing if there
/// is none; then call estimate_irradiance.  maps: those it was built from.  query.radius and
/// query.lobes are not used.  Thread-safe with a scratch for each thread.
std::optional<Rgb> nearest_irradiance(const PhotonIrradiance& irradiance,
                                      const DissertationMaps& maps, const Partition& partition,
                                      const PhotonQuery& query, TreeScratch& scratch);

} // namespace hipmap
