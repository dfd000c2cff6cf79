#include "render/maps/find_photons.h"

#include "common/partition/limiting_radius.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace hipmap {

namespace {

double distance_to_segment(const glm::dvec3& point, const glm::dvec3& a, const glm::dvec3& b)
{
    const glm::dvec3 along = b - a;
    const double length2 = glm::dot(along, along);
    const double t = length2 > 0 ? std::clamp(glm::dot(point - a, along) / length2, 0.0, 1.0) : 0.0;
    return glm::length(point - (a + t * along));
}

TreeQuery wanted(const PhotonMaps& maps, const PhotonQuery& query)
{
    return {query.position, maps.options.neighbours, query.radius * query.radius};
}

/// A search that lists what it finds.
struct Lists {
    using Found = FoundSlots;
    static std::size_t count(const Found& found) { return found.slots.size(); }
    static Found search(const PhotonMap& map, const TreeQuery& query, MapScratch& scratch)
    {
        return find_in_map(map, query, scratch);
    }
    static Found search(const LocalMap& local, const TreeQuery& query, MapScratch& scratch)
    {
        const Found found = find_in_map(local, query, scratch);
        for (std::uint32_t& slot : found.slots)
            slot = local.shared_slots[slot];
        return found;
    }
};

/// A search that adds the powers of what it finds, in wide trees.
struct Sums {
    using Found = NearestSum;
    static std::size_t count(const Found& found) { return found.photons; }
    template <typename Map>
    static Found search(const Map& map, const TreeQuery& query, MapScratch& scratch)
    {
        return sum_nearest(map.tree, map.powers, query, scratch);
    }
};

using LimitingRadius = float (*)(const TriangleMesh&, const Partition&, FaceId, const glm::vec3&);

/// A tier of local maps, and what is counted of it.
struct LocalTier {
    const LocalMaps& locals;
    LimitingRadius limiting_radius;
    TierSearches& searches;
};

/// Algorithm 4 of the thesis up to where it turns to the shared map; empty: it does turn there.
template <typename How>
typename How::Found find_in_local(const PhotonMaps& maps, const TriangleMesh& mesh,
                                  const Partition& partition, const PhotonQuery& query,
                                  const LocalTier& tier, MapScratch& scratch)
{
    if (tier.locals.maps.empty())
        return {};
    const std::uint32_t index = tier.locals.of_face[maps.index_by_side(query.face, query.side)];
    if (index == kNone)
        return {};
    const LocalMap& local = tier.locals.maps[index];
    const float limit = tier.limiting_radius(mesh, partition, query.face, query.position);
    if (local.filter_radius > limit) {
        ++tier.searches.skipped;
        return {};
    }
    ++tier.searches.begun;
    TreeQuery in_local = wanted(maps, query);
    // A photon at the limiting radius itself is already too far.
    in_local.radius2 = std::min(in_local.radius2, std::nextafter(limit * limit, 0.0f));
    in_local.order = local.shared_slots.data();
    const typename How::Found found = How::search(local, in_local, scratch);
    if (How::count(found) < in_local.photons && limit <= query.radius) {
        ++tier.searches.abandoned;
        return {};
    }
    return found;
}

/// The radius that the k-th photon is likely to have: by the last search in the shared map or by
/// the tier's density.
float expected_radius(const WideTree& shared, const TierMap& map, const TreeQuery& query,
                      const TreeScratch& scratch)
{
    const float step = glm::distance(query.point, scratch.last_point);
    const bool near = scratch.last_tree == shared.number && step < scratch.last_radius;
    return near ? scratch.last_radius + step : map.filter_radius;
}

/// Photons of one tier, if they are what the shared map would give; else none, and the radius in
/// which the tier has k is remembered for the next one.
template <typename How>
typename How::Found find_in_tier(const PhotonMap& shared, const TierMap& tier, TreeQuery query,
                                 float limit, TierSearches& searches, MapScratch& scratch)
{
    if (expected_radius(shared.tree, tier, query, scratch) > limit) {
        ++searches.skipped;
        return {};
    }
    ++searches.begun;
    query.from = tier.node;
    const typename How::Found found = How::search(shared, query, scratch);
    const float reached2 = How::count(found) == query.photons ? found.farthest2 : query.radius2;
    if (reached2 < limit * limit || !std::isfinite(limit))
        return found;
    ++searches.abandoned;
    scratch.last_missed = true;
    if (!std::isfinite(scratch.last_radius))
        scratch.last_tree = 0;
    return {};
}

template <typename How>
typename How::Found find_in_tiers(const PhotonMaps& maps, const PhotonMap& shared,
                                  const TriangleMesh& mesh, const Partition& partition,
                                  const PhotonQuery& query, SearchScratch& scratch)
{
    using Found = typename How::Found;
    const auto search = [&](const TierMaps& tier, auto limiting_radius, TierSearches& searches) {
        if (tier.of_face.empty())
            return Found();
        const std::uint32_t index = tier.of_face[maps.index_by_side(query.face, query.side)];
        if (index == kNone)
            return Found();
        const float limit = limiting_radius(mesh, partition, query.face, query.position);
        return find_in_tier<How>(shared, tier.maps[index], wanted(maps, query), limit, searches,
                                 scratch.shared);
    };
    SearchStatistics& statistics = scratch.statistics;
    Found found = search(maps.local_tier, exact_limiting_radius, statistics.local);
    if (How::count(found) == 0)
        found = search(maps.group_tier, exact_group_radius, statistics.group);
    return found;
}

/// In whichever tier answers; `map` is that of the query.
template <typename How>
typename How::Found find_in_any(const PhotonMaps& maps, const PhotonMap& map,
                                const TriangleMesh& mesh, const Partition& partition,
                                const PhotonQuery& query, SearchScratch& scratch)
{
    SearchStatistics& statistics = scratch.statistics;
    const bool thesis = maps.options.mode == MapMode::thesis;
    const LocalTier faces{maps.locals, thesis ? limiting_radius : exact_limiting_radius,
                          statistics.local};
    typename How::Found found =
        find_in_local<How>(maps, mesh, partition, query, faces, scratch.local);
    if (How::count(found) == 0) {
        const LocalTier groups{maps.groups, exact_group_radius, statistics.group};
        found = find_in_local<How>(maps, mesh, partition, query, groups, scratch.local);
    }
    if (!maps.local_tier.maps.empty() || !maps.group_tier.maps.empty())
        found = find_in_tiers<How>(maps, map, mesh, partition, query, scratch);
    if (How::count(found) == 0)
        found = How::search(map, wanted(maps, query), scratch.shared);
    statistics.photons_found += How::count(found);
    return found;
}

} // namespace

TierSearches& TierSearches::operator+=(const TierSearches& other)
{
    begun += other.begun;
    skipped += other.skipped;
    abandoned += other.abandoned;
    return *this;
}

SearchStatistics& SearchStatistics::operator+=(const SearchStatistics& other)
{
    queries += other.queries;
    local += other.local;
    group += other.group;
    photons_found += other.photons_found;
    return *this;
}

float limiting_radius(const TriangleMesh& mesh, const Partition& partition, FaceId face,
                      const glm::vec3& point)
{
    double nearest = std::numeric_limits<double>::infinity();
    const glm::uvec3 corners = mesh.corners[face];
    for (int c = 0; c < 3; ++c) {
        if (partition.edge_class[3 * std::size_t{face} + c] != EdgeClass::connected)
            continue;
        nearest = std::min(
            nearest, distance_to_segment(glm::dvec3(point), glm::dvec3(mesh.positions[corners[c]]),
                                         glm::dvec3(mesh.positions[corners[(c + 1) % 3]])));
    }
    return static_cast<float>(nearest);
}

const PhotonMap* map_of_query(const PhotonMaps& maps, const Partition& partition,
                              const PhotonQuery& query)
{
    const MapId id = maps.options.mode == MapMode::global ? 0 : partition.map_of_face[query.face];
    return id == kNone ? nullptr : maps.map_at(id, query.side);
}

FoundPhotons find_photons(const PhotonMaps& maps, const TriangleMesh& mesh,
                          const Partition& partition, const PhotonQuery& query,
                          SearchScratch& scratch)
{
    scratch.statistics.queries += maps.size > 0 ? 1 : 0;
    const PhotonMap* map = map_of_query(maps, partition, query);
    if (map == nullptr)
        return {};
    if (passes_over(maps)) {
        const FoundPhotons found = find_in_shared(maps, partition, query, scratch.shared);
        scratch.statistics.photons_found += found.slots.size();
        return found;
    }
    const FoundSlots found = find_in_any<Lists>(maps, *map, mesh, partition, query, scratch);
    return {map, found.slots, found.farthest2};
}

FoundSum sum_photons(const PhotonMaps& maps, const TriangleMesh& mesh, const Partition& partition,
                     const PhotonQuery& query, SearchScratch& scratch)
{
    assert(!passes_over(maps) && maps.options.tree == TreeKind::wide);
    scratch.statistics.queries += maps.size > 0 ? 1 : 0;
    const PhotonMap* map = map_of_query(maps, partition, query);
    if (map == nullptr)
        return {};
    return {map, find_in_any<Sums>(maps, *map, mesh, partition, query, scratch)};
}

} // namespace hipmap
