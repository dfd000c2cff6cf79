#include "render/maps/fixed_radius.h"

#include "render/maps/gather.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

namespace hipmap {

namespace {

RadiusEstimates estimate_from_sums(const PhotonMaps& maps, const PhotonMap& map,
                                   const PhotonQuery& query, const std::array<float, 3>& radii,
                                   EstimateScratch& scratch)
{
    const std::array<float, 3> radii2{radii[0] * radii[0], radii[1] * radii[1],
                                      radii[2] * radii[2]};
    const RadiusSums<3> sums =
        sum_within(map.tree, map.powers, query.position, radii2, scratch.search.within);
    RadiusEstimates out;
    out.photons = static_cast<std::uint32_t>(sums[0].photons);
    for (std::size_t r = 0; r < radii.size(); ++r)
        out.irradiance[r] =
            per_area(maps.power_scale, glm::dvec3(sums[r].power), disc_area(radii[r]));
    return out;
}

/// Adds up photon by photon those that count.  radii[0] > 0.  bounded: scratch.disc looks past
/// boundaries.
RadiusEstimates estimate_from_list(const PhotonMaps& maps, const MapSurfaces& surfaces,
                                   const PhotonQuery& query, const std::array<float, 3>& radii,
                                   bool bounded, EstimateScratch& scratch)
{
    const bool facing_only = maps.options.estimate == EstimateForm::thesis; // (7)
    const bool tilted = bounded && !scratch.segments.empty();               // (4)
    PhotonQuery within = query;
    within.radius = radii[0];
    constexpr std::size_t kAll = std::numeric_limits<std::uint32_t>::max();
    const FoundPhotons found =
        find_most_in_shared(maps, surfaces.partition, within, kAll, scratch.search.within);
    RadiusEstimates out;
    std::array<glm::dvec3, 3> sums{};
    for (const std::uint32_t slot : found.slots) {
        const MetPhoton photon{*found.map, slot};
        const glm::vec3 position = found.map->tree.position(slot);
        if ((bounded && !scratch.disc.sees(position)) ||
            (facing_only && !faces_query(photon, query)))
            continue;
        const glm::dvec3 power =
            tilted ? projected_power(photon, query, surfaces) : gathered_power(photon, query);
        const glm::vec3 d = position - query.position;
        for (std::size_t r = 0; r < radii.size(); ++r)
            if (glm::dot(d, d) <= radii[r] * radii[r])
                sums[r] += power;
        ++out.photons;
    }
    for (std::size_t r = 0; r < radii.size() && out.photons > 0; ++r) {
        const bool cut = bounded && radii[r] > 0;
        out.irradiance[r] = per_area(maps.power_scale, sums[r],
                                     cut ? scratch.disc.area(radii[r]) : disc_area(radii[r]));
    }
    return out;
}

/// For a query with a map, and a first radius above zero.
RadiusEstimates estimate_in_map(const PhotonMaps& maps, const PhotonMap& map,
                                const MapSurfaces& surfaces, const PhotonQuery& query,
                                const std::array<float, 3>& radii, EstimateScratch& scratch)
{
    const bool whole = counts_whole(maps, query);
    // No boundary needs to be looked at where there is no photon.  Beside a boundary a list will be
    // needed anyhow.
    const bool sums_first = whole && !std::exchange(scratch.near_boundary, false);
    RadiusEstimates from_sums;
    if (sums_first) {
        from_sums = estimate_from_sums(maps, map, query, radii, scratch);
        if (from_sums.photons == 0)
            return from_sums;
    }
    if (maps.options.estimate == EstimateForm::thesis || maps.options.mode == MapMode::global)
        return estimate_from_list(maps, surfaces, query, radii, false, scratch);
    const float seen = look_around(surfaces, query, radii[0], scratch);
    if (!(seen > 0))
        return {};
    if (seen == radii[0] && whole && scratch.segments.empty())
        return sums_first ? from_sums : estimate_from_sums(maps, map, query, radii, scratch);
    // In proportion, so that what the estimates differ by still tells the bias of the first.
    const float shrink = seen / radii[0];
    const std::array<float, 3> used{seen, std::min(seen, shrink * radii[1]), shrink * radii[2]};
    const RadiusEstimates out =
        estimate_from_list(maps, surfaces, query, seen == radii[0] ? radii : used, true, scratch);
    scratch.near_boundary = !scratch.segments.empty() && out.photons > 0;
    return out;
}

} // namespace

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
    const RadiusEstimates out = estimate_in_map(maps, *map, surfaces, query, radii, scratch);
    statistics.photons_found += out.photons;
    return out;
}

} // namespace hipmap
