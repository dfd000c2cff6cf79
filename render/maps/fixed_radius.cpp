#include "render/maps/fixed_radius.h"

#include "render/maps/gather.h"
#include "render/maps/seen_photons.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

namespace hipmap {

namespace {

RadiusEstimates estimate_from_sums(const PhotonMap& map, const RadiusQuery& wanted,
                                   EstimateScratch& scratch)
{
    const std::array<float, 3>& radii = wanted.radii;
    const std::array<float, 3> radii2{radii[0] * radii[0], radii[1] * radii[1],
                                      radii[2] * radii[2]};
    const RadiusSums<3> sums =
        sum_within(map.tree, map.powers, wanted.query.position, radii2, scratch.search.within);
    RadiusEstimates out;
    out.photons = static_cast<std::uint32_t>(sums[0].photons);
    for (std::size_t r = 0; r < radii.size(); ++r)
        out.irradiance[r] = per_area(wanted.scale, glm::dvec3(sums[r].power), disc_area(radii[r]));
    return out;
}

/// All photons of the query's map within its radius.
FoundPhotons list_within(const PhotonMap& map, const PhotonQuery& query, TreeScratch& scratch)
{
    constexpr std::size_t kAll = std::numeric_limits<std::uint32_t>::max();
    const FoundSlots found =
        find_nearest(map.tree, {query.position, kAll, query.radius * query.radius}, scratch);
    return {&map, found.slots, found.farthest2};
}

/// Estimates from the photons of the map that the query lies in.  wanted: its first radius is above
/// zero.
RadiusEstimates estimate_in_map(const PhotonMap& map, const RadiusQuery& wanted,
                                EstimateScratch& scratch)
{
    PhotonQuery query = wanted.query;
    const std::array<float, 3>& radii = wanted.radii;
    query.radius = radii[0];
    const bool folds = wanted.surfaces.may_fold(query.face);
    // No boundary needs to be looked at where there is no photon.  Beside a boundary a list will be
    // needed anyhow.
    const bool sums_first = query.lobes == nullptr && !std::exchange(scratch.near_boundary, false);
    RadiusEstimates from_sums;
    FoundPhotons found;
    if (sums_first) {
        from_sums = estimate_from_sums(map, wanted, scratch);
        if (from_sums.photons == 0)
            return from_sums;
    } else {
        found = list_within(map, query, scratch.search.within);
        if (found.slots.empty())
            return {};
    }
    const float seen = look_around(wanted.surfaces, query, radii[0], scratch);
    if (!(seen > 0))
        return {};
    if (sums_first && !folds && seen == radii[0] && scratch.segments.empty())
        return from_sums;
    query.radius = seen;
    if (sums_first || seen < radii[0])
        found = list_within(map, query, scratch.search.within);
    const RadiusEstimates out = estimate_from_list(
        found, {wanted.scale, wanted.surfaces, wanted.query, narrowed(radii, seen)}, scratch);
    scratch.near_boundary = (folds || !scratch.segments.empty()) && out.photons > 0;
    return out;
}

using Slots = std::span<const std::uint32_t>;

/// Writes the slots of the photons that the query sees to `out` and returns them.
Slots seen_of(Slots slots, const FoundPhotons& found, const RadiusQuery& wanted,
              const VisibleDisc& disc, std::array<std::uint32_t, kBatch>& out)
{
    const bool folds = wanted.surfaces.may_fold(wanted.query.face);
    const bool weighed = wanted.query.lobes != nullptr;
    PhotonPlaces places;
    for (const std::uint32_t slot : slots) {
        // Soon read: memory is what an estimate waits for.
        __builtin_prefetch(&found.map->powers.blocks[slot / kTreeWidth]);
        if (weighed)
            __builtin_prefetch(&found.map->directions[slot]);
        places.add(found.map->tree.position(slot));
    }
    std::size_t count = 0;
    for (std::uint64_t left = seen_photons(disc, places); left != 0; left &= left - 1) {
        const std::uint32_t slot = slots[static_cast<std::size_t>(std::countr_zero(left))];
        if (!folds || is_on_side({*found.map, slot}, wanted.query, wanted.surfaces))
            out[count++] = slot;
    }
    return {out.data(), count};
}

} // namespace

std::array<float, 3> narrowed(const std::array<float, 3>& radii, float seen)
{
    if (seen == radii[0])
        return radii;
    const float shrink = seen / radii[0];
    return {seen, std::min(seen, shrink * radii[1]), shrink * radii[2]};
}

RadiusEstimates estimate_from_list(const FoundPhotons& found, const RadiusQuery& wanted,
                                   const EstimateScratch& scratch)
{
    const bool tilted = !scratch.segments.empty();
    RadiusEstimates out;
    SumsByRadius sums;
    std::array<std::uint32_t, kBatch> slots;
    for_each_batch(found.slots, [&](Slots batch) {
        const Slots seen = seen_of(batch, found, wanted, scratch.disc, slots);
        if (!seen.empty())
            add_photons(*found.map, seen, wanted, tilted, sums);
        out.photons += static_cast<std::uint32_t>(seen.size());
    });
    if (out.photons == 0)
        return out;
    const auto areas = gathered_areas(wanted.surfaces, wanted.query, wanted.radii, scratch);
    for (std::size_t r = 0; r < areas.size(); ++r)
        out.irradiance[r] = per_area(wanted.scale, sums.at(r), areas[r]);
    return out;
}

RadiusEstimates estimate_within(const PhotonMaps& maps, const MapSurfaces& surfaces,
                                const PhotonQuery& query, const std::array<float, 3>& radii,
                                EstimateScratch& scratch)
{
    assert(radii[0] >= radii[1] && radii[1] >= radii[2] && radii[2] >= 0);
    SearchStatistics& statistics = scratch.search.statistics;
    statistics.queries += maps.size > 0 ? 1 : 0;
    const PhotonMap* map = map_of_query(maps, surfaces.partition, query);
    if (map == nullptr || !(radii[0] > 0))
        return {};
    const RadiusEstimates out =
        estimate_in_map(*map, {maps.power_scale, surfaces, query, radii}, scratch);
    statistics.photons_found += out.photons;
    return out;
}

} // namespace hipmap
