#include "render/maps/find_photons.h"

#include "common/partition/limiting_radius.h"

#include <algorithm>
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

/// Algorithm 4 of the thesis up to where it turns to the shared map; empty: it does turn there.
FoundPhotons find_in_local(const PhotonMaps& maps, const PhotonQuery& query, float limit,
                           SearchScratch& scratch)
{
    const std::uint32_t index = maps.local_of_face[maps.index_by_side(query.face, query.side)];
    if (index == kNone)
        return {};
    const LocalMap& local = maps.locals[index];
    if (local.filter_radius > limit) {
        ++scratch.statistics.local.skipped;
        return {};
    }
    ++scratch.statistics.local.begun;
    // A photon at the limiting radius itself is already too far.
    const float below = std::nextafter(limit * limit, 0.0f);
    const TreeQuery wanted{query.position, maps.options.neighbours,
                           std::min(below, query.radius * query.radius)};
    const FoundSlots found = find_nearest(local.tree, wanted, scratch.local);
    if (found.slots.size() < wanted.photons && limit <= query.radius) {
        ++scratch.statistics.local.abandoned;
        return {};
    }
    for (std::uint32_t& photon : found.slots)
        photon = local.photons[photon];
    return {found.slots, found.farthest2};
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
FoundSlots find_in_tier(const WideTree& shared, const TierMap& map, TreeQuery query, float limit,
                        TierSearches& searches, TreeScratch& scratch)
{
    if (expected_radius(shared, map, query, scratch) > limit) {
        ++searches.skipped;
        return {};
    }
    ++searches.begun;
    query.from = map.node;
    const FoundSlots found = find_nearest(shared, query, scratch);
    const float reached2 = found.slots.size() == query.photons ? found.farthest2 : query.radius2;
    if (reached2 < limit * limit || !std::isfinite(limit))
        return found;
    ++searches.abandoned;
    scratch.last_missed = true;
    if (!std::isfinite(scratch.last_radius))
        scratch.last_tree = 0;
    return {};
}

FoundPhotons find_in_tiers(const PhotonMaps& maps, const TriangleMesh& mesh,
                           const Partition& partition, const PhotonQuery& query,
                           SearchScratch& scratch)
{
    const MapId id = partition.map_of_face[query.face];
    if (id == kNone)
        return {};
    const std::size_t map = maps.map_index(id, query.side);
    const TreeQuery wanted{query.position, maps.options.neighbours, query.radius * query.radius};
    const auto search = [&](const TierMaps& tier, auto limiting_radius, TierSearches& searches) {
        if (tier.of_face.empty())
            return FoundSlots();
        const std::uint32_t index = tier.of_face[maps.index_by_side(query.face, query.side)];
        if (index == kNone)
            return FoundSlots();
        const float limit = limiting_radius(mesh, partition, query.face, query.position);
        return find_in_tier(maps.trees[map], tier.maps[index], wanted, limit, searches,
                            scratch.shared);
    };
    SearchStatistics& statistics = scratch.statistics;
    FoundSlots found = search(maps.local_tier, exact_limiting_radius, statistics.local);
    if (found.slots.empty())
        found = search(maps.group_tier, exact_group_radius, statistics.group);
    for (std::uint32_t& photon : found.slots)
        photon += static_cast<std::uint32_t>(maps.first_photon[map]);
    return {found.slots, found.farthest2};
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

float even_radius(const PhotonMaps& maps, const Partition& partition, const PhotonQuery& query)
{
    const MapId id = partition.map_of_face[query.face];
    if (id == kNone)
        return std::numeric_limits<float>::infinity();
    const std::size_t map = maps.map_index(id, query.side);
    return filter_radius(maps.map_area[map], maps.options.neighbours, maps.trees[map].size);
}

FoundPhotons find_photons(const PhotonMaps& maps, const TriangleMesh& mesh,
                          const Partition& partition, const PhotonQuery& query,
                          SearchScratch& scratch)
{
    if (maps.photons.empty())
        return {};
    ++scratch.statistics.queries;
    FoundPhotons found;
    if (maps.options.mode == MapMode::thesis) {
        const float limit = limiting_radius(mesh, partition, query.face, query.position);
        found = find_in_local(maps, query, limit, scratch);
    }
    if (!maps.local_tier.maps.empty() || !maps.group_tier.maps.empty())
        found = find_in_tiers(maps, mesh, partition, query, scratch);
    if (found.photons.empty())
        found = find_in_shared(maps, partition, query, scratch.shared);
    scratch.statistics.photons_found += found.photons.size();
    return found;
}

} // namespace hipmap
