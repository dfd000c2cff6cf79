#include "render/maps/estimate.h"

#include "render/maps/gather.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

namespace hipmap {

namespace {

using Slots = std::span<const std::uint32_t>;

/// How far beyond the k-th photon to look once boundaries hide some of them: in a right-angled
/// corner a quarter of the disc is left, so that twice the radius holds as many.
constexpr float kWiden = 2;

/// What an estimate is made from.
struct Gathering {
    const PhotonMaps& maps;
    const MapSurfaces& surfaces;
    const PhotonQuery& query;
    const PhotonMap& map;
};

Rgb density(const Gathering& from, Slots slots, double area)
{
    glm::dvec3 sum(0.0);
    for (const std::uint32_t slot : slots)
        sum += gathered_power({from.map, slot}, from.query);
    return per_area(from.maps.power_scale, sum, area);
}

/// Over an area measured in the plane of the query's face.
Rgb projected_density(const Gathering& from, Slots slots, double area)
{
    glm::dvec3 sum(0.0);
    for (const std::uint32_t slot : slots)
        sum += projected_power({from.map, slot}, from.query, from.surfaces);
    return per_area(from.maps.power_scale, sum, area);
}

float farthest(const FoundPhotons& found)
{
    return std::sqrt(found.farthest2);
}

/// docs/photon_maps.md (2): the k-th photon gives the radius and is left out of the sum.
Slots all_but_last(const FoundPhotons& found)
{
    return found.slots.first(found.slots.size() - 1);
}

bool sees_all(const FoundPhotons& found, const VisibleDisc& disc)
{
    return std::all_of(found.slots.begin(), found.slots.end(), [&](std::uint32_t slot) {
        return disc.sees(found.map->tree.position(slot));
    });
}

/// Searches once more among the visible photons only.
Rgb estimate_visible(const PhotonMaps& maps, const MapSurfaces& surfaces, PhotonQuery query,
                     float radius, EstimateScratch& scratch)
{
    query.radius = look_around(surfaces, query, radius, scratch);
    if (!(query.radius > 0))
        return Rgb(0);
    const auto seen = [&](const PhotonMap& map, std::uint32_t slot) {
        return scratch.disc.sees(map.tree.position(slot));
    };
    const FoundPhotons found =
        find_in_shared(maps, surfaces.partition, query, scratch.search.accepted, seen);
    if (found.slots.empty())
        return Rgb(0);
    const Gathering from{maps, surfaces, query, *found.map};
    if (found.slots.size() == maps.options.neighbours)
        return projected_density(from, all_but_last(found), scratch.disc.area(farthest(found)));
    if (scratch.segments.empty())
        return density(from, found.slots, disc_area(query.radius));
    return projected_density(from, found.slots, scratch.disc.area(query.radius));
}

/// docs/photon_maps.md (3): too few photons for (2).
Rgb estimate_sparse(const Gathering& from, const FoundPhotons& found, EstimateScratch& scratch)
{
    const bool one_map = from.maps.options.mode == MapMode::global;
    if (std::isfinite(from.query.radius)) {
        if (one_map)
            return density(from, found.slots, disc_area(from.query.radius));
        return estimate_visible(from.maps, from.surfaces, from.query, from.query.radius, scratch);
    }
    if (one_map)
        return density(from, all_but_last(found), disc_area(farthest(found)));
    return density(from, found.slots, from.surfaces.area_read(from.maps, from.query.face));
}

/// (2) and (3) where no boundary is near, from sums alone; nothing where one is.
std::optional<Rgb> estimate_from_sums(const PhotonMaps& maps, const MapSurfaces& surfaces,
                                      const PhotonQuery& query, EstimateScratch& scratch)
{
    const SearchStatistics before = scratch.search.statistics;
    const FoundSum found =
        sum_photons(maps, surfaces.mesh, surfaces.partition, query, scratch.search);
    if (found.nearest.photons == 0)
        return Rgb(0);
    const glm::dvec3 sum(found.nearest.power);
    const bool sparse = found.nearest.photons < maps.options.neighbours;
    const float radius = sparse ? query.radius : std::sqrt(found.nearest.farthest2);
    if (!std::isfinite(radius))
        return per_area(maps.power_scale, sum, surfaces.area_read(maps, query.face));
    if (!(radius > 0))
        return Rgb(0);
    if (look_around(surfaces, query, radius, scratch) == radius && scratch.segments.empty())
        return per_area(maps.power_scale, sum, disc_area(radius));
    scratch.search.statistics = before; // the search for a list counts
    return {};
}

/// docs/photon_maps.md (7).
Rgb estimate_plainly(const PhotonMaps& maps, const MapSurfaces& surfaces, PhotonQuery query,
                     EstimateScratch& scratch)
{
    query.radius = std::numeric_limits<float>::infinity();
    const FoundPhotons found =
        find_photons(maps, surfaces.mesh, surfaces.partition, query, scratch.search);
    glm::dvec3 sum(0.0);
    for (const std::uint32_t slot : found.slots)
        if (const MetPhoton photon{*found.map, slot}; faces_query(photon, query))
            sum += gathered_power(photon, query);
    return per_area(maps.power_scale, sum, disc_area(farthest(found)));
}

} // namespace

MapSurfaces::MapSurfaces(const TriangleMesh& of_mesh, const Partition& of_partition)
    : mesh(of_mesh), partition(of_partition), boundaries(of_mesh, of_partition)
{
    normals.reserve(mesh.face_count());
    std::vector<double> area(partition.map_count, 0.0);
    for (FaceId face = 0; face < mesh.face_count(); ++face) {
        const glm::dvec3 normal = scaled_normal(mesh, face);
        const double length = glm::length(normal);
        const double sign = partition.flipped[face] != 0 ? -1 : 1;
        normals.push_back(length > 0 ? glm::vec3(normal * (sign / length)) : glm::vec3(0));
        if (partition.map_of_face[face] != kNone)
            area[partition.map_of_face[face]] += length / 2;
    }
    map_area.assign(area.begin(), area.end());
    total_area = static_cast<float>(std::accumulate(area.begin(), area.end(), 0.0));
}

float even_radius(const PhotonMaps& maps, const MapSurfaces& surfaces, const PhotonQuery& query)
{
    if (surfaces.partition.map_of_face[query.face] == kNone)
        return std::numeric_limits<float>::infinity();
    const PhotonMap* map = map_of_query(maps, surfaces.partition, query);
    if (map == nullptr)
        return std::numeric_limits<float>::infinity();
    return filter_radius(surfaces.area_read(maps, query.face), maps.options.neighbours,
                         map->tree.size);
}

Rgb estimate_irradiance(const PhotonMaps& maps, const MapSurfaces& surfaces,
                        const PhotonQuery& query, EstimateScratch& scratch)
{
    if (maps.options.estimate == EstimateForm::thesis)
        return estimate_plainly(maps, surfaces, query, scratch);
    if (counts_whole(maps, query) && !scratch.near_boundary)
        if (const std::optional<Rgb> sum = estimate_from_sums(maps, surfaces, query, scratch))
            return *sum;
    scratch.near_boundary = false;
    const FoundPhotons found =
        find_photons(maps, surfaces.mesh, surfaces.partition, query, scratch.search);
    if (found.slots.empty())
        return Rgb(0);
    const Gathering from{maps, surfaces, query, *found.map};
    if (found.slots.size() < maps.options.neighbours)
        return estimate_sparse(from, found, scratch);

    const float radius = farthest(found);
    if (maps.options.mode == MapMode::global)
        return density(from, all_but_last(found), disc_area(radius));
    if (!(radius > 0))
        return Rgb(0);
    const bool to_the_end = look_around(surfaces, query, radius, scratch) == radius;
    scratch.near_boundary = !scratch.segments.empty();
    if (to_the_end && scratch.segments.empty())
        return density(from, all_but_last(found), disc_area(radius));
    if (to_the_end && sees_all(found, scratch.disc))
        return projected_density(from, all_but_last(found), scratch.disc.area(radius));
    return estimate_visible(maps, surfaces, query, std::min(kWiden * radius, query.radius),
                            scratch);
}

} // namespace hipmap
