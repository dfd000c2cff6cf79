#pragma once

#include "render/maps/gather.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace hipmap {

/// The steps of clipped_estimate.  A Search has
///     maps' options() and power_scale(), `surfaces` and `scratch`;
///     nearest(query): the k nearest photons, FoundPhotons;
///     accepted(query, accept): the k nearest that accept(map, slot) lets through;
///     adds_up(): whether it has nearest_sum(query), the powers of the nearest without a list;
///     counted() and recount(): its statistics, to be put back for a search made twice.
namespace clipped {

using Slots = std::span<const std::uint32_t>;

/// The factor of the radius within which to search once boundaries hide some photons: in a
/// right-angled corner a quarter of the disc is left, so that twice the radius holds as many.
inline constexpr float kWiden = 2;

inline float farthest(const FoundPhotons& found)
{
    return std::sqrt(found.farthest2);
}

/// Returns the slots that count, docs/photon_maps.md (2): the k-th photon gives the radius and is
/// left out of the sum.
inline Slots all_but_last(const FoundPhotons& found)
{
    return found.slots.first(found.slots.size() - 1);
}

inline bool sees_all(const FoundPhotons& found, const VisibleDisc& disc)
{
    return std::all_of(found.slots.begin(), found.slots.end(), [&](std::uint32_t slot) {
        return disc.sees(found.map->tree.position(slot));
    });
}

template <typename Search>
Rgb density(const Search& search, const PhotonQuery& query, const PhotonMap& map, Slots slots,
            double area)
{
    glm::dvec3 sum(0.0);
    for_each_power(map, slots, query,
                   [&](std::uint32_t, const glm::dvec3& power) { sum += power; });
    return per_area(search.power_scale(), sum, area);
}

/// Estimates the density over an area measured in the plane of the query's face.
template <typename Search>
Rgb projected_density(const Search& search, const PhotonQuery& query, const PhotonMap& map,
                      Slots slots, double area)
{
    glm::dvec3 sum(0.0);
    for_each_power(map, slots, query, [&](std::uint32_t slot, const glm::dvec3& power) {
        sum += power * facing({map, slot}, query, search.surfaces);
    });
    return per_area(search.power_scale(), sum, area);
}

template <typename Search>
double gathered_area(const Search& search, const PhotonQuery& query, float radius)
{
    return gathered_areas(search.surfaces, query, {&radius, 1}, search.scratch)[0];
}

/// Returns the k nearest photons on the query's side of the surface: nearly always the k nearest of
/// all, else those of a second search.
template <typename Search>
FoundPhotons nearest_on_side(const Search& search, const PhotonQuery& query)
{
    const FoundPhotons found = search.nearest(query);
    const auto on_side = [&](const PhotonMap& map, std::uint32_t slot) {
        return is_on_side({map, slot}, query, search.surfaces);
    };
    if (!search.surfaces.may_fold(query.face) ||
        std::ranges::all_of(found.slots,
                            [&](std::uint32_t slot) { return on_side(*found.map, slot); }))
        return found;
    return search.accepted(query, on_side);
}

/// Estimates by a second search, among the visible photons only.
template <typename Search>
Rgb estimate_visible(const Search& search, PhotonQuery query, float radius)
{
    EstimateScratch& scratch = search.scratch;
    query.radius = look_around(search.surfaces, query, radius, scratch);
    if (!(query.radius > 0))
        return Rgb(0);
    const bool folds = search.surfaces.may_fold(query.face);
    const auto seen = [&](const PhotonMap& map, std::uint32_t slot) {
        return scratch.disc.sees(map.tree.position(slot)) &&
               (!folds || is_on_side({map, slot}, query, search.surfaces));
    };
    const FoundPhotons found = search.accepted(query, seen);
    if (found.slots.empty())
        return Rgb(0);
    if (found.slots.size() == search.options().neighbours)
        return projected_density(search, query, *found.map, all_but_last(found),
                                 gathered_area(search, query, farthest(found)));
    if (scratch.segments.empty())
        return density(search, query, *found.map, found.slots,
                       gathered_area(search, query, query.radius));
    return projected_density(search, query, *found.map, found.slots,
                             gathered_area(search, query, query.radius));
}

/// Estimates (2) and (3) where no boundary is near, from sums alone; returns nothing where one is.
template <typename Search>
std::optional<Rgb> estimate_from_sums(const Search& search, const PhotonQuery& query)
{
    const auto before = search.counted();
    const FoundSum found = search.nearest_sum(query);
    if (found.nearest.photons == 0)
        return Rgb(0);
    const glm::dvec3 sum(found.nearest.power);
    const bool sparse = found.nearest.photons < search.options().neighbours;
    const float radius = sparse ? query.radius : std::sqrt(found.nearest.farthest2);
    if (!std::isfinite(radius))
        return per_area(search.power_scale(), sum, search.surfaces.area_at(query.face));
    if (!(radius > 0))
        return Rgb(0);
    if (look_around(search.surfaces, query, radius, search.scratch) == radius &&
        search.scratch.segments.empty())
        return per_area(search.power_scale(), sum, disc_area(radius));
    search.recount(before); // the search for a list counts
    return {};
}

/// Estimates (3), for a query with fewer than k photons on its side within its radius: those of the
/// whole map, on all its sides, if the radius is infinite.
template <typename Search>
Rgb estimate_sparse(const Search& search, const PhotonQuery& query)
{
    if (std::isfinite(query.radius))
        return estimate_visible(search, query, query.radius);
    const FoundPhotons found = search.nearest(query);
    if (found.slots.empty())
        return Rgb(0);
    if (found.slots.size() == search.options().neighbours)
        return estimate_visible(search, query, farthest(found));
    return density(search, query, *found.map, found.slots, search.surfaces.area_at(query.face));
}

} // namespace clipped

/// Implements estimate_irradiance with any search: docs/photon_maps.md (2) to (4).
template <typename Search>
Rgb clipped_estimate(const Search& search, const PhotonQuery& query)
{
    using namespace clipped;
    EstimateScratch& scratch = search.scratch;
    if (search.adds_up() && query.lobes == nullptr && !scratch.near_boundary &&
        !search.surfaces.may_fold(query.face))
        if (const std::optional<Rgb> sum = estimate_from_sums(search, query))
            return *sum;
    scratch.near_boundary = false;
    const FoundPhotons found = nearest_on_side(search, query);
    if (found.slots.empty() && std::isfinite(query.radius))
        return Rgb(0);
    if (found.slots.size() < search.options().neighbours)
        return estimate_sparse(search, query);
    const float radius = farthest(found);
    if (!(radius > 0))
        return Rgb(0);
    const bool to_the_end = look_around(search.surfaces, query, radius, scratch) == radius;
    scratch.near_boundary = !scratch.segments.empty();
    if (to_the_end && scratch.segments.empty())
        return density(search, query, *found.map, all_but_last(found),
                       gathered_area(search, query, radius));
    if (to_the_end && sees_all(found, scratch.disc))
        return projected_density(search, query, *found.map, all_but_last(found),
                                 gathered_area(search, query, radius));
    return estimate_visible(search, query, std::min(kWiden * radius, query.radius));
}

} // namespace hipmap
