#pragma once

#include "render/dissertation/dissertation.h"
#include "render/dissertation/kd_tree.h"
#include "render/dissertation/photon_irradiance.h"

#include <optional>

namespace hipmap {

/// The photons of a face (or group) and side that has many of them, by reference into their shared
/// map.
struct LocalMap {
    WideTree tree;
    PhotonPowers powers;                     ///< beside it
    KdTree kd_tree;                          ///< searched instead, if the options say so
    std::vector<std::uint32_t> shared_slots; ///< [n] by slot
    float filter_radius = 0.0f;              ///< docs/photon_maps.md (5), scene units
};

/// Local maps of faces or of groups.
struct LocalMaps {
    std::vector<std::uint32_t> of_face; ///< [sides() F] by index_by_side; kNone; empty without maps
    std::vector<LocalMap> maps;
};

/// The part of a shared map's tree that holds all photons of a face, or of a group of faces.
struct LevelMap {
    TreeNode node;
    float filter_radius = 0.0f; ///< docs/photon_maps.md (5), scene units
};

/// Local or group maps of mode hierarchical.
struct LevelMaps {
    LevelPlan plan;
    std::vector<std::uint32_t> of_face; ///< [sides() F] by index_by_side; kNone; empty: not used
    std::vector<LevelMap> maps;
};

/// The maps of one kind of photon in any mode except none, with any tree and form of estimate.
/// Read-only once built: any number of threads may search.
struct DissertationMaps {
    DissertationOptions options;
    PhotonMaps shared;                  ///< mode global: one, at every place of map_of
    std::vector<KdTree> kd_trees;       ///< [maps] searched instead of their trees, which are then
                                        ///< blocks alone; empty: wide trees
    float total_area = 0;               ///< of all shared maps, square scene units
    LocalMaps locals;                   ///< mode thesis; hierarchical on kd-trees
    LocalMaps groups;                   ///< hierarchical on kd-trees
    LevelMaps local_level, group_level; ///< hierarchical on wide trees
    std::optional<PhotonIrradiance> irradiance;

    bool one_map() const { return options.mode == MapMode::global; }
    /// Returns how many sides of a surface have their own maps: the thesis' estimate drops photons
    /// of the wrong side only when they are chosen.
    std::uint8_t sides() const { return options.estimate == EstimateForm::thesis ? 1 : 2; }
    std::size_t index_by_side(std::uint32_t face_or_group, std::uint8_t side) const
    {
        return std::size_t{sides()} * face_or_group + side % sides();
    }
    /// Returns the kd-tree of a map; null: the map's wide tree is searched.
    const KdTree* kd_tree(const PhotonMap& map) const
    {
        return kd_trees.empty() ? nullptr
                                : &kd_trees[static_cast<std::size_t>(&map - shared.maps.data())];
    }
    /// Returns the area of the map that a query on `face` reads; the face must have one.
    float area_read(const MapSurfaces& surfaces, FaceId face) const
    {
        return one_map() ? total_area : surfaces.area_at(face);
    }
};

/// Scratch memory of one thread, in addition to that for shared maps.
struct DissertationScratch {
    TreeScratch local;
    TreeScratch irradiance;
    KdScratch kd;
    LevelStatistics levels;
};

/// Splits photons into maps as build_photon_maps does, with the map levels and the irradiance at
/// every fourth photon that the options ask for.  asked.mode: not none.
DissertationMaps build_dissertation_maps(const std::vector<Photon>& photons,
                                         const MapSurfaces& surfaces, const MapOptions& options,
                                         const DissertationOptions& asked);

} // namespace hipmap
