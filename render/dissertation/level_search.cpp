#include "render/dissertation/level_search.h"

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

/// A query of some maps.
struct Asked {
    const DissertationMaps& maps;
    const MapSurfaces& surfaces;
    const PhotonQuery& query;

    TreeQuery in_tree() const
    {
        return {query.position, maps.shared.options.neighbours, query.radius * query.radius};
    }
    /// Returns the index of the query's face in a level's table.
    std::size_t index() const { return maps.index_by_side(query.face, query.side); }
};

/// A search that lists what it finds.
struct Lists {
    using Found = FoundSlots;
    static std::size_t count(const Found& found) { return found.slots.size(); }
    static Found search(const Asked& asked, const PhotonMap& map, const TreeQuery& query,
                        const EitherScratch& scratch)
    {
        return find_in_map(asked.maps.kd_tree(map), map.tree, query, scratch);
    }
    static Found search(const Asked& asked, const LocalMap& local, const TreeQuery& query,
                        const EitherScratch& scratch)
    {
        const bool wide = asked.maps.options.tree == TreeKind::wide;
        const Found found =
            find_in_map(wide ? nullptr : &local.kd_tree, local.tree, query, scratch);
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
    static Found search(const Asked&, const Map& map, const TreeQuery& query,
                        const EitherScratch& scratch)
    {
        return sum_nearest(map.tree, map.powers, query, scratch.wide);
    }
};

using LimitingRadius = float (*)(const TriangleMesh&, const Partition&, FaceId, const glm::vec3&);

/// The limiting radius of a map level, and the counts of the searches there.
struct LevelRule {
    LimitingRadius limiting_radius;
    LevelSearches& searches;
};

float limit_of(const Asked& asked, const LevelRule& rule)
{
    return rule.limiting_radius(asked.surfaces.mesh, asked.surfaces.partition, asked.query.face,
                                asked.query.position);
}

/// Algorithm 4 of the thesis up to where it turns to the shared map; empty: it does turn there.
template <typename How>
typename How::Found find_in_local(const Asked& asked, const LocalMaps& locals,
                                  const LevelRule& rule, const EitherScratch& scratch)
{
    if (locals.maps.empty())
        return {};
    const std::uint32_t index = locals.of_face[asked.index()];
    if (index == kNone)
        return {};
    const LocalMap& local = locals.maps[index];
    const float limit = limit_of(asked, rule);
    if (local.filter_radius > limit) {
        ++rule.searches.skipped;
        return {};
    }
    ++rule.searches.begun;
    TreeQuery in_local = asked.in_tree();
    // A photon at the limiting radius itself is already too far.
    in_local.radius2 = std::min(in_local.radius2, std::nextafter(limit * limit, 0.0f));
    in_local.order = local.shared_slots.data();
    const typename How::Found found = How::search(asked, local, in_local, scratch);
    if (How::count(found) < in_local.photons && limit <= asked.query.radius) {
        ++rule.searches.abandoned;
        return {};
    }
    return found;
}

/// The radius that the k-th photon is likely to have: by the last search in the shared map or by
/// the level's density.
float expected_radius(const WideTree& shared, const LevelMap& map, const TreeQuery& query,
                      const TreeScratch& scratch)
{
    const float step = glm::distance(query.point, scratch.last_point);
    const bool near = scratch.last_tree == shared.number && step < scratch.last_radius;
    return near ? scratch.last_radius + step : map.filter_radius;
}

/// Photons of one level, if they are what the shared map would give; else none, and the radius in
/// which the level has k is remembered for the next one.
template <typename How>
typename How::Found find_in_level(const Asked& asked, const PhotonMap& shared,
                                  const LevelMaps& level, const LevelRule& rule,
                                  const EitherScratch& scratch)
{
    if (level.of_face.empty())
        return {};
    const std::uint32_t index = level.of_face[asked.index()];
    if (index == kNone)
        return {};
    const float limit = limit_of(asked, rule);
    TreeQuery query = asked.in_tree();
    if (expected_radius(shared.tree, level.maps[index], query, scratch.wide) > limit) {
        ++rule.searches.skipped;
        return {};
    }
    ++rule.searches.begun;
    query.from = level.maps[index].node;
    const typename How::Found found = How::search(asked, shared, query, scratch);
    const float reached2 = How::count(found) == query.photons ? found.farthest2 : query.radius2;
    if (reached2 < limit * limit || !std::isfinite(limit))
        return found;
    ++rule.searches.abandoned;
    scratch.wide.last_missed = true;
    if (!std::isfinite(scratch.wide.last_radius))
        scratch.wide.last_tree = 0;
    return {};
}

/// In the map levels below the shared maps; empty: only the shared map can tell.
template <typename How>
typename How::Found find_below(const Asked& asked, const PhotonMap& map,
                               const LevelScratch& scratch)
{
    const DissertationMaps& maps = asked.maps;
    const bool thesis = maps.options.mode == MapMode::thesis;
    DissertationScratch& below = scratch.below;
    LevelStatistics& counts = below.levels;
    const EitherScratch local{below.local, below.kd}, shared{scratch.shared.nearest, below.kd};
    const LevelRule in_local{thesis ? limiting_radius : exact_limiting_radius, counts.local};
    const LevelRule in_group{exact_group_radius, counts.group};
    typename How::Found found = find_in_local<How>(asked, maps.locals, in_local, local);
    if (How::count(found) == 0)
        found = find_in_local<How>(asked, maps.groups, in_group, local);
    if (How::count(found) == 0)
        found = find_in_level<How>(asked, map, maps.local_level, in_local, shared);
    if (How::count(found) == 0)
        found = find_in_level<How>(asked, map, maps.group_level, in_group, shared);
    return found;
}

/// In whichever level answers; `map` is that of the query.
template <typename How>
typename How::Found find_in_any(const Asked& asked, const PhotonMap& map,
                                const LevelScratch& scratch)
{
    typename How::Found found = find_below<How>(asked, map, scratch);
    if (How::count(found) == 0)
        found =
            How::search(asked, map, asked.in_tree(), {scratch.shared.nearest, scratch.below.kd});
    scratch.shared.statistics.photons_found += How::count(found);
    return found;
}

} // namespace

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

const PhotonMap* map_of_query(const DissertationMaps& maps, const Partition& partition,
                              const PhotonQuery& query)
{
    if (maps.one_map())
        return maps.shared.maps.empty() ? nullptr : &maps.shared.maps[0];
    return map_of_query(maps.shared, partition, query);
}

FoundPhotons find_photons(const DissertationMaps& maps, const MapSurfaces& surfaces,
                          const PhotonQuery& query, const LevelScratch& scratch)
{
    SearchStatistics& statistics = scratch.shared.statistics;
    statistics.queries += maps.shared.size > 0 ? 1 : 0;
    const PhotonMap* map = map_of_query(maps, surfaces.partition, query);
    if (map == nullptr)
        return {};
    if (passes_over(maps)) {
        const FoundPhotons found =
            find_in_shared(maps, surfaces.partition, {query, maps.shared.options.neighbours},
                           {scratch.shared.nearest, scratch.below.kd});
        statistics.photons_found += found.slots.size();
        return found;
    }
    const FoundSlots found = find_in_any<Lists>({maps, surfaces, query}, *map, scratch);
    return {map, found.slots, found.farthest2};
}

FoundSum sum_photons(const DissertationMaps& maps, const MapSurfaces& surfaces,
                     const PhotonQuery& query, const LevelScratch& scratch)
{
    assert(!passes_over(maps) && maps.options.tree == TreeKind::wide);
    scratch.shared.statistics.queries += maps.shared.size > 0 ? 1 : 0;
    const PhotonMap* map = map_of_query(maps, surfaces.partition, query);
    if (map == nullptr)
        return {};
    return {map, find_in_any<Sums>({maps, surfaces, query}, *map, scratch)};
}

} // namespace hipmap
