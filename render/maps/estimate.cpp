#include "render/maps/estimate.h"

#include <cmath>
#include <numbers>

namespace hipmap {

namespace {

using Found = std::span<const Neighbour>;

/// How far beyond the k-th photon to look once boundaries hide some of them: in a right-angled
/// corner a quarter of the disc is left, so that twice the radius holds as many.
constexpr float kWiden = 2;

Rgb total_power(const PhotonMaps& maps, Found photons)
{
    Rgb sum(0.0f);
    for (const Neighbour& neighbour : photons)
        sum += maps.photons[neighbour.photon].power;
    return sum;
}

Rgb density(const PhotonMaps& maps, Found photons, double area)
{
    if (photons.empty() || !(area > 0))
        return Rgb(0);
    const Rgb out = total_power(maps, photons) / static_cast<float>(area);
    return is_finite(out) ? out : Rgb(0);
}

double disc_area(float radius)
{
    return std::numbers::pi * (double{radius} * radius);
}

float farthest(Found found)
{
    return std::sqrt(found.back().distance2);
}

/// docs/photon_maps.md (2): the k-th photon gives the radius and is left out of the sum.
Rgb density_within_last(const PhotonMaps& maps, Found found, double area)
{
    return density(maps, found.first(found.size() - 1), area);
}

void look_around(const MapSurfaces& surfaces, const PhotonQuery& query, float radius,
                 EstimateScratch& scratch)
{
    scratch.segments.clear();
    surfaces.boundaries.near(surfaces.partition.map_of_face[query.face], query.position, radius,
                             scratch.segments);
    const glm::uvec3 c = surfaces.mesh.corners[query.face];
    const std::vector<glm::vec3>& p = surfaces.mesh.positions;
    scratch.disc.look({{p[c.x], p[c.y], p[c.z]}, query.position, radius}, scratch.segments);
}

bool sees_all(const PhotonMaps& maps, Found found, const VisibleDisc& disc)
{
    for (const Neighbour& neighbour : found)
        if (!disc.sees(maps.photons[neighbour.photon].position))
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
    const Found found = find_in_shared(maps, surfaces.partition, query, scratch.search, seen);
    if (found.size() == maps.options.neighbours)
        return density_within_last(maps, found, scratch.disc.area(farthest(found)));
    return density(maps, found, scratch.disc.area(radius));
}

/// docs/photon_maps.md (3): too few photons for (2).
Rgb estimate_sparse(const PhotonMaps& maps, const MapSurfaces& surfaces, const PhotonQuery& query,
                    Found found, EstimateScratch& scratch)
{
    if (std::isfinite(query.radius)) {
        if (maps.options.mode == MapMode::global)
            return density(maps, found, disc_area(query.radius));
        return estimate_visible(maps, surfaces, query, query.radius, scratch);
    }
    if (maps.options.mode == MapMode::global)
        return density_within_last(maps, found, disc_area(farthest(found)));
    const MapId map = surfaces.partition.map_of_face[query.face];
    return density(maps, found, maps.map_area[maps.map_index(map, query.side)]);
}

} // namespace

Rgb estimate_irradiance(const PhotonMaps& maps, const MapSurfaces& surfaces,
                        const PhotonQuery& query, EstimateScratch& scratch)
{
    const Found found =
        find_photons(maps, surfaces.mesh, surfaces.partition, query, scratch.search);
    if (found.empty())
        return Rgb(0);
    if (found.size() < maps.options.neighbours)
        return estimate_sparse(maps, surfaces, query, found, scratch);

    const float radius = farthest(found);
    if (maps.options.mode == MapMode::global)
        return density_within_last(maps, found, disc_area(radius));
    if (!(radius > 0))
        return Rgb(0);
    look_around(surfaces, query, radius, scratch);
    if (scratch.segments.empty())
        return density_within_last(maps, found, disc_area(radius));
    if (sees_all(maps, found, scratch.disc))
        return density_within_last(maps, found, scratch.disc.area(radius));
    return estimate_visible(maps, surfaces, query, std::min(kWiden * radius, query.radius),
                            scratch);
}

} // namespace hipmap
