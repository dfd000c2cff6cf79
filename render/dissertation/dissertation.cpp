#include "render/dissertation/dissertation.h"

#include "render/dissertation/level_search.h"
#include "render/maps/clipped_estimate.h"

#include <cassert>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>
#include <tuple>
#include <utility>

namespace hipmap {

namespace {

using Owned = std::shared_ptr<const DissertationMaps>;

DissertationScratch& scratch_of(ChosenScratch& scratch)
{
    if (!scratch.dissertation)
        scratch.dissertation = std::make_shared<DissertationScratch>();
    return *scratch.dissertation;
}

const DissertationMaps* dissertation_maps(const ChosenMaps& maps)
{
    const Owned* owned = std::get_if<Owned>(&maps);
    return owned == nullptr ? nullptr : owned->get();
}

/// Searches maps with their levels and kd-trees.
struct LevelledSearch {
    const DissertationMaps& maps;
    const MapSurfaces& surfaces;
    EstimateScratch& scratch;
    DissertationScratch& below;

    const MapOptions& options() const { return maps.shared.options; }
    const PowerScale& power_scale() const { return maps.shared.power_scale; }
    bool adds_up() const { return maps.options.tree == TreeKind::wide; }
    FoundPhotons nearest(const PhotonQuery& query) const
    {
        return find_photons(maps, surfaces, query, {scratch.search, below});
    }
    FoundSum nearest_sum(const PhotonQuery& query) const
    {
        return sum_photons(maps, surfaces, query, {scratch.search, below});
    }
    template <typename Accept>
    FoundPhotons accepted(const PhotonQuery& query, const Accept& accept) const
    {
        return find_in_shared(maps, surfaces.partition, {query, options().neighbours},
                              {scratch.search.accepted, below.kd}, accept);
    }
    std::pair<SearchStatistics, LevelStatistics> counted() const
    {
        return {scratch.search.statistics, below.levels};
    }
    void recount(const std::pair<SearchStatistics, LevelStatistics>& counted) const
    {
        std::tie(scratch.search.statistics, below.levels) = counted;
    }
};

/// Estimates from one map without boundaries, over whole discs, docs/photon_maps.md (2) and (3).
Rgb estimate_in_one_map(const LevelledSearch& search, const PhotonQuery& query)
{
    const FoundPhotons found = search.nearest(query);
    if (found.slots.empty())
        return Rgb(0);
    if (found.slots.size() < search.options().neighbours && std::isfinite(query.radius))
        return clipped::density(search, query, *found.map, found.slots, disc_area(query.radius));
    return clipped::density(search, query, *found.map, clipped::all_but_last(found),
                            disc_area(clipped::farthest(found)));
}

/// docs/photon_maps.md (7).
Rgb estimate_plainly(const LevelledSearch& search, PhotonQuery query)
{
    query.radius = std::numeric_limits<float>::infinity();
    const FoundPhotons found = search.nearest(query);
    if (found.slots.empty())
        return Rgb(0);
    glm::dvec3 sum(0.0);
    for_each_power(*found.map, found.slots, query,
                   [&](std::uint32_t slot, const glm::dvec3& power) {
                       if (glm::dot(found.map->direction(slot), query.normal) > 0)
                           sum += power;
                   });
    return per_area(search.power_scale(), sum, disc_area(clipped::farthest(found)));
}

/// Photon by photon over whole discs.
RadiusEstimates estimate_in_discs(const FoundPhotons& found, const RadiusQuery& wanted)
{
    RadiusEstimates out;
    SumsByRadius sums;
    for_each_batch(found.slots, [&](std::span<const std::uint32_t> batch) {
        add_photons(*found.map, batch, wanted, false, sums);
    });
    out.photons = static_cast<std::uint32_t>(found.slots.size());
    for (std::size_t r = 0; r < out.irradiance.size() && out.photons > 0; ++r)
        out.irradiance[r] = per_area(wanted.scale, sums.at(r), disc_area(wanted.radii[r]));
    return out;
}

/// In one map, or with kd-trees: by a list of photons.  radii[0] > 0.
RadiusEstimates estimate_from_all(const DissertationMaps& maps, const MapSurfaces& surfaces,
                                  const PhotonQuery& query, std::array<float, 3> radii,
                                  ChosenScratch& scratch)
{
    EstimateScratch& estimate = scratch.estimate;
    if (!maps.one_map()) {
        const float seen = look_around(surfaces, query, radii[0], estimate);
        if (!(seen > 0))
            return {};
        radii = narrowed(radii, seen);
    }
    PhotonQuery within = query;
    within.radius = radii[0];
    constexpr std::size_t kAll = std::numeric_limits<std::uint32_t>::max();
    const FoundPhotons found = find_in_shared(maps, surfaces.partition, {within, kAll},
                                              {estimate.search.within, scratch_of(scratch).kd});
    const RadiusQuery wanted{maps.shared.power_scale, surfaces, query, radii};
    return maps.one_map() ? estimate_in_discs(found, wanted)
                          : estimate_from_list(found, wanted, estimate);
}

} // namespace

bool asks_for_shared(const DissertationOptions& asked)
{
    return (asked.mode == MapMode::shared || asked.mode == MapMode::none) &&
           asked.estimate == EstimateForm::clipped && asked.tree == TreeKind::wide &&
           asked.irradiance == GatheredIrradiance::estimated;
}

LevelSearches& LevelSearches::operator+=(const LevelSearches& other)
{
    begun += other.begun;
    skipped += other.skipped;
    abandoned += other.abandoned;
    return *this;
}

LevelStatistics& LevelStatistics::operator+=(const LevelStatistics& other)
{
    local += other.local;
    group += other.group;
    return *this;
}

std::string describe_plan(const LevelPlan& plan)
{
    std::ostringstream out;
    out << (plan.used ? "used" : "not used");
    if (!plan.counted)
        out << " (a search would save at most " << plan.most
            << " tree nodes; the lookup of its map costs as much as " << plan.asking << ")";
    else
        out << " (" << std::lround(100 * plan.answered) << " % of searches would end there, "
            << (plan.saving > 0 ? "saving " : "losing ") << std::fixed << std::setprecision(2)
            << std::abs(plan.saving) << " tree nodes each)";
    return out.str();
}

ChosenMaps build_chosen_maps(const std::vector<Photon>& photons, const MapSurfaces& surfaces,
                             const MapOptions& options, const DissertationOptions& asked,
                             ChosenMaps* previous)
{
    if (asks_for_shared(asked))
        return build_photon_maps(photons, surfaces.partition, options,
                                 std::get_if<PhotonMaps>(previous));
    return std::make_shared<const DissertationMaps>(
        build_dissertation_maps(photons, surfaces, options, asked));
}

bool uses_methods(const DissertationOptions& options)
{
    return options.mode != MapMode::shared || options.estimate != EstimateForm::clipped ||
           options.tree != TreeKind::wide || options.irradiance != GatheredIrradiance::estimated;
}

DissertationOptions without_levels(DissertationOptions options)
{
    if (options.mode == MapMode::thesis || options.mode == MapMode::hierarchical)
        options.mode = MapMode::shared;
    return options;
}

const PhotonMaps& shared_maps(const ChosenMaps& maps)
{
    const DissertationMaps* compared = dissertation_maps(maps);
    return compared == nullptr ? std::get<PhotonMaps>(maps) : compared->shared;
}

LevelCounts count_levels(const ChosenMaps& maps)
{
    const DissertationMaps* compared = dissertation_maps(maps);
    if (compared == nullptr)
        return {};
    return {compared->locals.maps.size() + compared->local_level.maps.size(),
            compared->groups.maps.size() + compared->group_level.maps.size(),
            compared->local_level.plan, compared->group_level.plan};
}

std::size_t bytes_of(const ChosenMaps& maps)
{
    std::size_t sum = shared_maps(maps).bytes();
    const DissertationMaps* compared = dissertation_maps(maps);
    if (compared == nullptr)
        return sum;
    for (const KdTree& tree : compared->kd_trees)
        sum += tree.bytes();
    if (compared->irradiance)
        for (const PhotonIrradiance::Map& map : compared->irradiance->maps)
            sum += map.tree.bytes() + map.irradiance.size() * (sizeof(Rgb) + sizeof(glm::vec3));
    return sum;
}

LevelStatistics level_searches(const ChosenScratch& scratch)
{
    return scratch.dissertation ? scratch.dissertation->levels : LevelStatistics();
}

namespace dissertation {

Rgb estimate_irradiance(const DissertationMaps& maps, const MapSurfaces& surfaces,
                        const PhotonQuery& query, ChosenScratch& scratch)
{
    const LevelledSearch search{maps, surfaces, scratch.estimate, scratch_of(scratch)};
    if (maps.options.estimate == EstimateForm::thesis)
        return estimate_plainly(search, query);
    return maps.one_map() ? estimate_in_one_map(search, query) : clipped_estimate(search, query);
}

RadiusEstimates estimate_within(const DissertationMaps& maps, const MapSurfaces& surfaces,
                                const PhotonQuery& query, const std::array<float, 3>& radii,
                                ChosenScratch& scratch)
{
    assert(maps.options.estimate == EstimateForm::clipped);
    if (!maps.one_map() && maps.options.tree == TreeKind::wide)
        return hipmap::estimate_within(maps.shared, surfaces, query, radii, scratch.estimate);
    SearchStatistics& statistics = scratch.estimate.search.statistics;
    statistics.queries += maps.shared.size > 0 ? 1 : 0;
    if (map_of_query(maps, surfaces.partition, query) == nullptr || !(radii[0] > 0))
        return {};
    const RadiusEstimates out = estimate_from_all(maps, surfaces, query, radii, scratch);
    statistics.photons_found += out.photons;
    return out;
}

RadiusEstimates estimate_gathered(const DissertationMaps& maps, const MapSurfaces& surfaces,
                                  const PhotonQuery& query, const std::array<float, 3>& radii,
                                  ChosenScratch& scratch)
{
    if (maps.irradiance)
        if (const std::optional<Rgb> found = nearest_irradiance(
                *maps.irradiance, maps, surfaces.partition, query, scratch_of(scratch).irradiance))
            return {{*found, *found, *found}, 0};
    return estimate_within(maps, surfaces, query, radii, scratch);
}

float even_radius(const DissertationMaps& maps, const MapSurfaces& surfaces,
                  const PhotonQuery& query)
{
    const PhotonMap* map = map_of_query(maps, surfaces.partition, query);
    if (map == nullptr || surfaces.partition.map_of_face[query.face] == kNone)
        return std::numeric_limits<float>::infinity();
    return filter_radius(maps.area_read(surfaces, query.face), maps.shared.options.neighbours,
                         map->tree.size);
}

RadiusField build_radius_field(const DissertationMaps& maps, const MapSurfaces& surfaces,
                               const RadiusField::Rules& rules)
{
    RadiusField out;
    out.sparse = rules.sparse;
    out.index.options = maps.shared.options;
    out.index.map_of = maps.shared.map_of;
    for (const PhotonMap& map : maps.shared.maps)
        out.maps.push_back(build_radius_map(
            {map, maps.area_read(surfaces, map.faces[0]), maps.shared.options.neighbours,
             rules.sharp},
            surfaces, [&maps, &map] {
                return [&maps, &map, wide = TreeScratch(),
                        kd = KdScratch()](const TreeQuery& query) mutable {
                    return find_in_map(maps.kd_tree(map), map.tree, query, {wide, kd});
                };
            }));
    return out;
}

} // namespace dissertation

} // namespace hipmap
