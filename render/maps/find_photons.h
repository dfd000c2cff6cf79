#pragma once

#include "render/maps/photon_maps.h"
#include "render/maps/wide_search.h"
#include "render/maps/wide_sums.h"
#include "render/shading/photon_lobes.h"

#include <limits>

namespace hipmap {

/// The point, the face and the side at which photons are searched.
struct PhotonQuery {
    glm::vec3 position; ///< scene units
    glm::vec3 normal;   ///< geometric, unit, on the side that is looked at
    FaceId face = kNone;
    std::uint8_t side = 0;
    float radius = std::numeric_limits<float>::infinity(); ///< nothing farther counts
    const PhotonLobes* lobes = nullptr; ///< lobes that weight each photon; null: all count alike
};

/// Returns the query on the transmitted side of the surface.
inline PhotonQuery transmitted_side(PhotonQuery query)
{
    query.normal = -query.normal;
    query.side ^= 1;
    return query;
}

/// Counts of the searches of one thread; sums are independent of the order of queries.
struct SearchStatistics {
    std::uint64_t queries = 0;
    std::uint64_t photons_found = 0;

    SearchStatistics& operator+=(const SearchStatistics& other);
};

/// Scratch memory of one thread for its searches, so that none allocates.  Each kind of search
/// remembers its own last search.
struct SearchScratch {
    TreeScratch nearest;
    TreeScratch accepted; ///< of searches that turn photons down
    TreeScratch within;   ///< of searches for all photons within a radius
    SearchStatistics statistics;
};

/// The photons that a search found; valid until its scratch is used again.
struct FoundPhotons {
    const PhotonMap* map = nullptr;       ///< that they lie in
    std::span<const std::uint32_t> slots; ///< in the order of the tree, but the farthest is last
    float farthest2 = 0.0f;               ///< square distance of the last, square scene units
};

/// The sum of the powers of the photons that a search found.
struct FoundSum {
    const PhotonMap* map = nullptr;
    NearestSum nearest;
};

/// Returns the map that a query reads; null if it holds no photon.
const PhotonMap* map_of_query(const PhotonMaps& maps, const Partition& partition,
                              const PhotonQuery& query);

/// Finds the k nearest photons of the query's map, fewer if there are no more within the radius; of
/// equally near ones those with the lower slot.  A face without a map has none.
FoundPhotons find_photons(const PhotonMaps& maps, const Partition& partition,
                          const PhotonQuery& query, SearchScratch& scratch);

/// Returns the sum of what find_photons finds.
FoundSum sum_photons(const PhotonMaps& maps, const Partition& partition, const PhotonQuery& query,
                     SearchScratch& scratch);

/// Finds the k nearest photons of the query's map that `accept(map, slot)` lets through.
template <typename Accept>
FoundPhotons find_accepted(const PhotonMaps& maps, const Partition& partition,
                           const PhotonQuery& query, const Accept& accept, TreeScratch& scratch)
{
    const PhotonMap* map = map_of_query(maps, partition, query);
    if (map == nullptr)
        return {};
    const TreeQuery wanted{query.position, maps.options.neighbours, query.radius * query.radius};
    const FoundSlots found = find_nearest(map->tree, wanted, scratch,
                                          [&](std::uint32_t slot) { return accept(*map, slot); });
    return {map, found.slots, found.farthest2};
}

} // namespace hipmap
