#pragma once

#include "render/maps/photon_maps.h"
#include "render/maps/wide_sums.h"
#include "render/shading/gathered_lobes.h"

#include <limits>
#include <vector>

namespace hipmap {

/// Where photons are looked for.
struct PhotonQuery {
    glm::vec3 position; ///< scene units
    glm::vec3 normal;   ///< geometric, unit, on the side that is looked at
    FaceId face = kNone;
    std::uint8_t side = 0;
    float radius = std::numeric_limits<float>::infinity(); ///< nothing farther counts
    const GatheredLobes* lobes = nullptr; ///< that weigh each photon; none: all count alike
};

/// The same on the other side of the surface.
inline PhotonQuery beyond(PhotonQuery query)
{
    query.normal = -query.normal;
    query.side ^= 1;
    return query;
}

/// What was done in one tier below the shared maps.
struct TierSearches {
    std::uint64_t begun = 0;
    std::uint64_t skipped = 0;   ///< not begun: the radius expected exceeds the limiting radius
    std::uint64_t abandoned = 0; ///< begun, ran into the limiting radius, went on in the next tier

    TierSearches& operator+=(const TierSearches& other);
};

/// What the searches of one thread did; sums are independent of the order of queries.
struct SearchStatistics {
    std::uint64_t queries = 0;
    TierSearches local;
    TierSearches group; ///< mode hierarchical
    std::uint64_t photons_found = 0;

    SearchStatistics& operator+=(const SearchStatistics& other);
};

/// Memory for searches in maps of either kind of tree.
struct MapScratch : TreeScratch {
    KdScratch kd;
};

/// Memory that one thread lends to its searches, so that none allocates.  Each kind of search
/// remembers the last of its own kind.
struct SearchScratch {
    MapScratch shared;
    MapScratch local;
    MapScratch accepted; ///< of searches that turn photons down
    MapScratch within;   ///< of searches for all photons within a radius
    SearchStatistics statistics;
};

/// The photons that a search found; valid until its scratch is used again.
struct FoundPhotons {
    const PhotonMap* map = nullptr;       ///< that they lie in
    std::span<const std::uint32_t> slots; ///< in the order of the tree, but the farthest is last
    float farthest2 = 0.0f;               ///< square distance of the last, square scene units
};

/// Their powers.
struct FoundSum {
    const PhotonMap* map = nullptr;
    NearestSum nearest;
};

/// Distance from a point of `face` to the nearest edge across which its shared map goes on;
/// infinite if there is none.  Algorithm 4 of the thesis, docs/photon_maps.md (6).
float limiting_radius(const TriangleMesh& mesh, const Partition& partition, FaceId face,
                      const glm::vec3& point);

/// Whether searches pass over photons whose light fell on the side not looked at: in mode global
/// those of all surfaces are in one map.
inline bool passes_over(const PhotonMaps& maps)
{
    return maps.options.mode == MapMode::global && maps.options.estimate == EstimateForm::clipped;
}

/// The map of the first tier that a query reads; null if it holds no photon.
const PhotonMap* map_of_query(const PhotonMaps& maps, const Partition& partition,
                              const PhotonQuery& query);

/// The k nearest photons of the query's map, fewer if there are no more within the radius; of
/// equally near ones those with the lower slot.  A face without a map has none.
/// Mode thesis looks in the face's local map first; what it returns is what the shared map would,
/// in another order.  Mode hierarchical looks in the tiers it uses first; what it returns is what
/// mode shared does, in the same order, whatever the surface.  Trees of another kind find the same
/// too, in another order and by other slots.
FoundPhotons find_photons(const PhotonMaps& maps, const TriangleMesh& mesh,
                          const Partition& partition, const PhotonQuery& query,
                          SearchScratch& scratch);

/// The same photons, added up: for wide trees whose searches pass over no photon.
FoundSum sum_photons(const PhotonMaps& maps, const TriangleMesh& mesh, const Partition& partition,
                     const PhotonQuery& query, SearchScratch& scratch);

/// Searches the kind of tree that there is.  Map: PhotonMap or LocalMap.
template <typename Map, typename Accept = AcceptAll>
FoundSlots find_in_map(const Map& map, const TreeQuery& wanted, MapScratch& scratch,
                       const Accept& accept = {})
{
    if (map.kd_tree.size() > 0)
        return find_nearest(map.kd_tree, wanted, scratch.kd, accept);
    return find_nearest(map.tree, wanted, scratch, accept);
}

/// The `most` nearest from the first tier alone, of the photons that `accept(map, slot)` lets
/// through.
template <typename Accept = AcceptAll>
FoundPhotons find_most_in_shared(const PhotonMaps& maps, const Partition& partition,
                                 const PhotonQuery& query, std::size_t most, MapScratch& scratch,
                                 const Accept& accept = {})
{
    const PhotonMap* map = map_of_query(maps, partition, query);
    if (map == nullptr)
        return {};
    const TreeQuery wanted{query.position, most, query.radius * query.radius};
    FoundSlots found;
    if (passes_over(maps)) {
        found = find_in_map(*map, wanted, scratch, [&](std::uint32_t slot) {
            return glm::dot(map->direction(slot), query.normal) > 0 && accept(*map, slot);
        });
    } else if constexpr (std::is_same_v<Accept, AcceptAll>) {
        found = find_in_map(*map, wanted, scratch);
    } else {
        found = find_in_map(*map, wanted, scratch,
                            [&](std::uint32_t slot) { return accept(*map, slot); });
    }
    return {map, found.slots, found.farthest2};
}

/// The k nearest of those.
template <typename Accept = AcceptAll>
FoundPhotons find_in_shared(const PhotonMaps& maps, const Partition& partition,
                            const PhotonQuery& query, MapScratch& scratch,
                            const Accept& accept = {})
{
    return find_most_in_shared(maps, partition, query, maps.options.neighbours, scratch, accept);
}

} // namespace hipmap
