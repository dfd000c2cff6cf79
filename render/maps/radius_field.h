#pragma once

#include "render/maps/estimate.h"

#include <functional>
#include <vector>

namespace hipmap {

/// A radius at every point of the surfaces that follows the density of some photons: the distance
/// to the k-th of them, docs/photon_maps.md (10).  The photons need not be kept.  Read-only once
/// built: any number of threads may use it.
struct RadiusField {
    /// The radii of one map.
    struct Map {
        WideTree tree;             ///< of some of its photons
        std::vector<float> radius; ///< [n] by slot: where the k-th photon is, or narrower
        float even_radius = 0.0f;  ///< docs/photon_maps.md (5), of all its photons
        bool sparse = false;       ///< it has fewer than k photons
    };
    /// The radius where a map has fewer than k photons.
    enum class Sparse : std::uint8_t {
        even,    ///< the even radius: an estimate over much of the map
        infinite ///< no estimate: the light is found in another way
    };
    /// What radii are like.
    struct Rules {
        Sparse sparse = Sparse::even;
        bool sharp = false; ///< narrower where photons are dense and where they end, for light with
                            ///< sharp edges: docs/photon_maps.md (11), (12)
    };
    PhotonMaps index; ///< of the photons, without them
    std::vector<Map> maps;
    Sparse sparse = Sparse::even;
};

/// A map whose radii are looked for.
struct MapOfRadii {
    const PhotonMap& photons;
    float area = 0.0f; ///< of its surface, square scene units
    std::uint32_t neighbours = 0;
    bool sharp = false; ///< RadiusField::Rules::sharp
};

/// Finds the k nearest photons of a map, fewer if there are no more within the radius; for one
/// thread.
using NearestSearch = std::function<FoundSlots(const TreeQuery&)>;

/// Computes the radii of one map of a field, in parallel; narrower where the surface is,
/// docs/visible_area.md (A10).  make_search: returns a search of the map's photons for one thread.
RadiusField::Map build_radius_map(const MapOfRadii& map, const MapSurfaces& surfaces,
                                  const std::function<NearestSearch()>& make_search);

/// Builds a radius field, in parallel.  Same maps, same field, at any thread count.  No photons: a
/// field without maps. Cost: a search for every fourth photon.
RadiusField build_radius_field(const PhotonMaps& photons, const MapSurfaces& surfaces,
                               const RadiusField::Rules& rules = {});

/// Returns the radius at a point, scene units: at most the radius within which k photons would lie
/// if the map's photons were spread evenly over it; where the map has no photon, that of one
/// photon.  Infinite where the map has fewer than k photons, if the field says so, and for a face
/// without a map.  A function of the point alone.  Thread-safe.  query.radius and query.lobes are
/// not used.
float radius_at(const RadiusField& field, const MapSurfaces& surfaces, const PhotonQuery& query);

} // namespace hipmap
