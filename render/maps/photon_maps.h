#pragma once

#include "common/partition/partition.h"
#include "render/maps/wide_tree.h"
#include "render/photons/photon.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace hipmap {

/// How photons are split into maps.
enum class MapMode : std::uint8_t {
    none,   ///< no photons at all
    global, ///< one map (Jensen 1996)
    shared, ///< one for each shared map of the partition and side (Larsen and Christensen 2003)
    thesis, ///< the same, and one for each face that has many photons (Mpawulo 2005)
    hierarchical, ///< shared, with the tiers below that pay
};

/// Which tiers mode hierarchical searches.
enum class TierChoice : std::uint8_t {
    paying, ///< those that are expected to save time, docs/photon_maps.md (8)
    all,    ///< all, to measure and to test
};

/// How the photons found become an irradiance, docs/photon_maps.md.
enum class EstimateForm : std::uint8_t {
    clipped, ///< k-1 photons over the visible part of their disc, (2) to (4)
    thesis,  ///< those of k photons that face the surface over the whole disc, (7)
};

struct MapOptions {
    MapMode mode = MapMode::shared;
    std::uint32_t neighbours = 50; ///< k, at least 1
    std::uint32_t local_min = 500; ///< M: fewest photons of a local map
    EstimateForm estimate = EstimateForm::clipped;
    TierChoice tiers = TierChoice::paying;
};

/// The photons of a face and side that has many of them, by reference into the photons of the set.
struct LocalMap {
    WideTree tree;
    std::vector<std::uint32_t> photons; ///< [n] by slot
    float filter_radius = 0.0f;         ///< docs/photon_maps.md (5), scene units
};

/// The part of a shared map's tree that holds all photons of a face, or of a group of faces.
struct TierMap {
    TreeNode node;
    float filter_radius = 0.0f; ///< docs/photon_maps.md (5), scene units
};

/// What a tier costs and saves, in nodes of a search, docs/photon_maps.md (8).
struct TierPlan {
    double asking = 0; ///< cost of asking for its map and limiting radius
    double most = 0;   ///< that any search could save
    bool used = false;

    bool counted = false;         ///< the rest: only where `most` exceeds the cost, or to measure
    std::uint64_t candidates = 0; ///< faces or groups of a side with enough photons
    std::uint64_t photons = 0;    ///< of them
    double asked = 0;             ///< share of searches on a face whose map begins below the root
    double answered = 0;          ///< share of searches that end within their limiting radius there
    double saving = 0;            ///< mean of all searches; below zero: a loss
};

/// Local or group maps of mode hierarchical.
struct TierMaps {
    TierPlan plan;
    std::vector<std::uint32_t> of_face; ///< [sides() F] by index_by_side; kNone; empty: not used
    std::vector<TierMap> maps;
};

/// All maps of one kind of photon (caustic or global).  Read-only once built: any number of threads
/// may search.
struct PhotonMaps {
    MapOptions options;
    std::vector<Photon> photons; ///< [n] map by map, by slot of its tree
    std::vector<std::uint64_t>
        first_photon;            ///< [maps + 1]: map m owns photons [first[m], first[m+1])
    std::vector<WideTree> trees; ///< [maps]; numbers are places in the order of (path, bounce)
    std::vector<float> map_area; ///< [maps] of the faces, square scene units
    std::vector<std::uint32_t>
        local_of_face; ///< [sides() F] by index_by_side; kNone; empty without locals
    std::vector<LocalMap> locals;
    TierMaps local_tier, group_tier; ///< mode hierarchical

    /// Sides of a surface that have maps of their own: the thesis' estimate drops photons of the
    /// wrong side only when they are chosen.
    std::uint8_t sides() const { return options.estimate == EstimateForm::thesis ? 1 : 2; }
    /// The map of a shared map and side: 0 in mode global.
    std::size_t map_index(MapId map, std::uint8_t side) const
    {
        return options.mode == MapMode::global ? 0 : index_by_side(map, side);
    }
    std::size_t index_by_side(std::uint32_t face_or_map, std::uint8_t side) const
    {
        return std::size_t{sides()} * face_or_map + side % sides();
    }
    /// Maps of the first tier that hold a photon.
    std::size_t filled_maps() const;
};

/// sqrt(A k / (pi N)), docs/photon_maps.md (5); infinite without photons.
float filter_radius(double area, std::uint32_t neighbours, std::uint64_t photons);

/// Splits `photons`, in the order of (path, bounce), into maps and builds their trees, in parallel.
/// O(n log n).  Same photons, same maps, at any thread count.  No photons: empty maps, which find
/// nothing.  Throws InputError for 2^32 photons or more.
PhotonMaps build_photon_maps(const std::vector<Photon>& photons, const TriangleMesh& mesh,
                             const Partition& partition, const MapOptions& options);

} // namespace hipmap
