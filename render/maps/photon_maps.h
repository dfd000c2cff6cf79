#pragma once

#include "common/partition/partition.h"
#include "render/maps/kd_tree.h"
#include "render/maps/packed_direction.h"
#include "render/maps/photon_powers.h"

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
    bool directions = false; ///< a lobe that is not separable will gather
    TreeKind tree = TreeKind::wide;

    /// Whether a gatherer asks for the directions of photons.
    bool keep_directions() const
    {
        return directions || mode == MapMode::global || estimate == EstimateForm::thesis;
    }
};

/// The photons of a shared map and side (mode global: all), packed.
struct PhotonMap {
    WideTree tree;
    KdTree kd_tree; ///< searched instead, if MapOptions::tree says so: `tree` is then blocks alone
    PhotonPowers powers;
    std::vector<FaceId> faces;               ///< [n] by slot
    std::vector<PackedDirection> directions; ///< [n] by slot; empty if nobody asks for them
    std::uint8_t side = 0;

    /// Unit, towards where the photon came from.  Only if directions are kept.
    glm::vec3 direction(std::uint32_t slot) const { return unpack_direction(directions[slot]); }
    /// Bytes of the arrays.
    std::size_t bytes() const
    {
        return tree.bytes() + kd_tree.bytes() + powers.bytes() + faces.size() * sizeof(FaceId) +
               directions.size() * sizeof(PackedDirection);
    }
};

/// The photons of a face (or group) and side that has many of them, by reference into their shared
/// map.
struct LocalMap {
    WideTree tree;
    PhotonPowers powers;                     ///< beside it
    KdTree kd_tree;                          ///< instead, if MapOptions::tree says so
    std::vector<std::uint32_t> shared_slots; ///< [n] by slot
    float filter_radius = 0.0f;              ///< docs/photon_maps.md (5), scene units
};

/// Local maps of faces or of groups.
struct LocalMaps {
    std::vector<std::uint32_t> of_face; ///< [sides() F] by index_by_side; kNone; empty without maps
    std::vector<LocalMap> maps;
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
    std::uint64_t size = 0; ///< photons
    PowerScale power_scale;
    std::vector<PhotonMap> maps;       ///< of the first tier, those that hold a photon
    std::vector<std::uint32_t> map_of; ///< by map_index: the place in `maps`; kNone: no photon
    LocalMaps locals;                  ///< mode thesis; hierarchical on kd-trees
    LocalMaps groups;                  ///< hierarchical on kd-trees
    TierMaps local_tier, group_tier;   ///< hierarchical on wide trees

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
    /// In `maps`; kNone if there is no photon.
    std::uint32_t place(MapId map, std::uint8_t side) const
    {
        return map_of.empty() ? kNone : map_of[map_index(map, side)];
    }
    /// Null if there is no photon.
    const PhotonMap* map_at(MapId map, std::uint8_t side) const
    {
        const std::uint32_t found = place(map, side);
        return found == kNone ? nullptr : &maps[found];
    }
    /// Bytes of the arrays of the first tier.
    std::size_t bytes() const;
    /// Photons of the largest map of the first tier.
    std::uint64_t largest_map() const;
};

/// sqrt(A k / (pi N)), docs/photon_maps.md (5); infinite without photons.
float filter_radius(double area, std::uint32_t neighbours, std::uint64_t photons);

/// Splits `photons`, in the order of (path, bounce), into maps and builds their trees, in parallel.
/// O(n log n).  Same photons, same maps, at any thread count.  About 23.7 bytes a photon are kept,
/// 27.7 with directions.  No photons: no maps, nothing is found.  Throws InputError for 2^32
/// photons or more.
PhotonMaps build_photon_maps(const std::vector<Photon>& photons, const TriangleMesh& mesh,
                             const Partition& partition, const MapOptions& options);

} // namespace hipmap
