#include "render/maps/estimate.h"

#include "render/maps/gather.h"

#include <cmath>

namespace hipmap {

namespace {

using Photons = std::span<const std::uint32_t>;

/// How far beyond the k-th photon to look once boundaries hide some of them: in a right-angled
/// corner a quarter of the disc is left, so that twice the radius holds as many.
constexpr float kWiden = 2;

Rgb density(const PhotonMaps& maps, const PhotonQuery& query, Photons photons, double area)
{
    Rgb sum(0.0f);
    for (const std::uint32_t photon : photons)
        sum += gathered_power(maps.photons[photon], query);
    return per_area(sum, area);
}

/// Over an area measured in the plane of the query's face.
Rgb projected_density(const PhotonMaps& maps, const MapSurfaces& surfaces, const PhotonQuery& query,
                      Photons photons, double area)
{
    Rgb sum(0.0f);
    for (const std::uint32_t i : photons)
        sum += projected_power(maps.photons[i], query, surfaces);
    return per_area(sum, area);
}

float farthest(const FoundPhotons& found)
{
    return std::sqrt(found.farthest2);
}

/// docs/photon_maps.md (2): the k-th photon gives the radius and is left out of the sum.
Photons all_but_last(const FoundPhotons& found)
{
    return found.photons.first(found.photons.size() - 1);
}

bool sees_all(const PhotonMaps& maps, Photons photons, const VisibleDisc& disc)
{
    for (const std::uint32_t photon : photons)
        if (!disc.sees(maps.photons[photon].position))
            return false;
    return true;
}

/// Searches once more among the visible photons only.
Rgb estimate_visible(const PhotonMaps& maps, const MapSurfaces& surfaces, PhotonQuery query,
                     float radius, EstimateScratch& scratch)
{
    query.radius = radius;
    look_around(surfaces, query, radius, scratch);
    const auto seen = [&](std::uint32_t i) { return scratch.disc.sees(maps.photons[i].position); };
    const FoundPhotons found =
        find_in_shared(maps, surfaces.partition, query, scratch.search.accepted, seen);
    if (found.photons.size() == maps.options.neighbours)
        return projected_density(maps, surfaces, query, all_but_last(found),
                                 scratch.disc.area(farthest(found)));
    if (scratch.segments.empty())
        return density(maps, query, found.photons, disc_area(radius));
    return projected_density(maps, surfaces, query, found.photons, scratch.disc.area(radius));
}

/// docs/photon_maps.md (3): too few photons for (2).
Rgb estimate_sparse(const PhotonMaps& maps, const MapSurfaces& surfaces, const PhotonQuery& query,
                    const FoundPhotons& found, EstimateScratch& scratch)
{
    if (std::isfinite(query.radius)) {
        if (maps.options.mode == MapMode::global)
            return density(maps, query, found.photons, disc_area(query.radius));
        return estimate_visible(maps, surfaces, query, query.radius, scratch);
    }
    if (maps.options.mode == MapMode::global)
        return density(maps, query, all_but_last(found), disc_area(farthest(found)));
    const MapId map = surfaces.partition.map_of_face[query.face];
    return density(maps, query, found.photons, maps.map_area[maps.map_index(map, query.side)]);
}

/// docs/photon_maps.md (7).
Rgb estimate_plainly(const PhotonMaps& maps, const MapSurfaces& surfaces, PhotonQuery query,
                     EstimateScratch& scratch)
{
    query.radius = std::numeric_limits<float>::infinity();
    const FoundPhotons found =
        find_photons(maps, surfaces.mesh, surfaces.partition, query, scratch.search);
    Rgb sum(0.0f);
    for (const std::uint32_t photon : found.photons)
        if (glm::dot(maps.photons[photon].direction, query.normal) > 0)
            sum += gathered_power(maps.photons[photon], query);
    return per_area(sum, disc_area(farthest(found)));
}

} // namespace

MapSurfaces::MapSurfaces(const TriangleMesh& of_mesh, const Partition& of_partition)
    : mesh(of_mesh), partition(of_partition), boundaries(of_mesh, of_partition)
{
    normals.reserve(mesh.face_count());
    for (FaceId face = 0; face < mesh.face_count(); ++face) {
        const glm::dvec3 normal = scaled_normal(mesh, face);
        const double length = glm::length(normal);
        const double sign = partition.flipped[face] != 0 ? -1 : 1;
        normals.push_back(length > 0 ? glm::vec3(normal * (sign / length)) : glm::vec3(0));
    }
}

Rgb estimate_irradiance(const PhotonMaps& maps, const MapSurfaces& surfaces,
                        const PhotonQuery& query, EstimateScratch& scratch)
{
    if (maps.options.estimate == EstimateForm::thesis)
        return estimate_plainly(maps, surfaces, query, scratch);
    const FoundPhotons found =
        find_photons(maps, surfaces.mesh, surfaces.partition, query, scratch.search);
    if (found.photons.empty())
        return Rgb(0);
    if (found.photons.size() < maps.options.neighbours)
        return estimate_sparse(maps, surfaces, query, found, scratch);

    const float radius = farthest(found);
    if (maps.options.mode == MapMode::global)
        return density(maps, query, all_but_last(found), disc_area(radius));
    if (!(radius > 0))
        return Rgb(0);
    look_around(surfaces, query, radius, scratch);
    if (scratch.segments.empty())
        return density(maps, query, all_but_last(found), disc_area(radius));
    if (sees_all(maps, found.photons, scratch.disc))
        return projected_density(maps, surfaces, query, all_but_last(found),
                                 scratch.disc.area(radius));
    return estimate_visible(maps, surfaces, query, std::min(kWiden * radius, query.radius),
                            scratch);
}

} // namespace hipmap
