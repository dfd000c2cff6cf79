#include "render/maps/find_photons.h"

namespace hipmap {

SearchStatistics& SearchStatistics::operator+=(const SearchStatistics& other)
{
    queries += other.queries;
    photons_found += other.photons_found;
    return *this;
}

const PhotonMap* map_of_query(const PhotonMaps& maps, const Partition& partition,
                              const PhotonQuery& query)
{
    const MapId id = partition.map_of(query.face);
    return id == kNone ? nullptr : maps.map_at(id, query.side);
}

FoundPhotons find_photons(const PhotonMaps& maps, const Partition& partition,
                          const PhotonQuery& query, SearchScratch& scratch)
{
    scratch.statistics.queries += maps.size > 0 ? 1 : 0;
    const PhotonMap* map = map_of_query(maps, partition, query);
    if (map == nullptr)
        return {};
    const FoundSlots found = find_nearest(
        map->tree, {query.position, maps.options.neighbours, query.radius * query.radius},
        scratch.nearest);
    scratch.statistics.photons_found += found.slots.size();
    return {map, found.slots, found.farthest2};
}

FoundSum sum_photons(const PhotonMaps& maps, const Partition& partition, const PhotonQuery& query,
                     SearchScratch& scratch)
{
    scratch.statistics.queries += maps.size > 0 ? 1 : 0;
    const PhotonMap* map = map_of_query(maps, partition, query);
    if (map == nullptr)
        return {};
    const NearestSum found = sum_nearest(
        map->tree, map->powers,
        {query.position, maps.options.neighbours, query.radius * query.radius}, scratch.nearest);
    scratch.statistics.photons_found += found.photons;
    return {map, found};
}

} // namespace hipmap
