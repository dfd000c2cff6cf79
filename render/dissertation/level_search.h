#pragma once

#include "render/dissertation/dissertation_maps.h"

namespace hipmap {

/// Returns the distance from a point of `face` to the nearest edge across which its shared map
/// continues; infinite if there is none.  Algorithm 4 of the thesis, docs/photon_maps.md (6).
float limiting_radius(const TriangleMesh& mesh, const Partition& partition, FaceId face,
                      const glm::vec3& point);

/// Scratch memory of one thread for searches of shared maps and the levels below them.
struct LevelScratch {
    SearchScratch& shared;
    DissertationScratch& below;
};

/// Scratch memory of one thread for searches of a tree of either kind.
struct EitherScratch {
    TreeScratch& wide;
    KdScratch& kd;
};

/// Returns whether searches pass over photons whose light fell on the other side: in mode global
/// one map holds the photons of all surfaces.
inline bool passes_over(const DissertationMaps& maps)
{
    return maps.one_map() && maps.options.estimate == EstimateForm::clipped;
}

/// Returns the shared map that a query reads (mode global: the one map); null if it holds no
/// photon.
const PhotonMap* map_of_query(const DissertationMaps& maps, const Partition& partition,
                              const PhotonQuery& query);

/// Finds the k nearest photons of the query's map, fewer if there are no more within the radius; of
/// equally near ones those with the lower slot.  A face without a map has none. Mode thesis looks
/// in the face's local map first; it returns the photons of the shared map, in another order.  Mode
/// hierarchical looks in the map levels it uses first; it returns what mode shared does, in the
/// same order, whatever the surface.  Kd-trees find the same photons, in another order and by other
/// slots.
FoundPhotons find_photons(const DissertationMaps& maps, const MapSurfaces& surfaces,
                          const PhotonQuery& query, const LevelScratch& scratch);

/// Returns the sum of what find_photons finds, for wide trees whose searches pass over no photon.
FoundSum sum_photons(const DissertationMaps& maps, const MapSurfaces& surfaces,
                     const PhotonQuery& query, const LevelScratch& scratch);

/// Searches the kd-tree, or without one the wide tree.
template <typename Accept = AcceptAll>
FoundSlots find_in_map(const KdTree* kd_tree, const WideTree& wide, const TreeQuery& wanted,
                       const EitherScratch& scratch, const Accept& accept = {})
{
    if (kd_tree != nullptr)
        return find_nearest(*kd_tree, wanted, scratch.kd, accept);
    return find_nearest(wide, wanted, scratch.wide, accept);
}

/// A query, and how many photons it asks for.
struct NearestQuery {
    const PhotonQuery& query;
    std::size_t most;
};

/// The wanted.most nearest photons of the shared map alone that `accept(map, slot)` lets through.
template <typename Accept = AcceptAll>
FoundPhotons find_in_shared(const DissertationMaps& maps, const Partition& partition,
                            const NearestQuery& wanted, const EitherScratch& scratch,
                            const Accept& accept = {})
{
    const PhotonQuery& query = wanted.query;
    const PhotonMap* map = map_of_query(maps, partition, query);
    if (map == nullptr)
        return {};
    const TreeQuery in_tree{query.position, wanted.most, query.radius * query.radius};
    const KdTree* const kd = maps.kd_tree(*map);
    FoundSlots found;
    if (passes_over(maps)) {
        found = find_in_map(kd, map->tree, in_tree, scratch, [&](std::uint32_t slot) {
            return glm::dot(map->direction(slot), query.normal) > 0 && accept(*map, slot);
        });
    } else if constexpr (std::is_same_v<Accept, AcceptAll>) {
        found = find_in_map(kd, map->tree, in_tree, scratch);
    } else {
        found = find_in_map(kd, map->tree, in_tree, scratch,
                            [&](std::uint32_t slot) { return accept(*map, slot); });
    }
    return {map, found.slots, found.farthest2};
}

} // namespace hipmap
