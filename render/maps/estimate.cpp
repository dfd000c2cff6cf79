#include "render/maps/estimate.h"

#include "render/maps/clipped_estimate.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hipmap {

namespace {

/// Searches the shared maps.
struct SharedSearch {
    const PhotonMaps& maps;
    const MapSurfaces& surfaces;
    EstimateScratch& scratch;

    const MapOptions& options() const { return maps.options; }
    const PowerScale& power_scale() const { return maps.power_scale; }
    static constexpr bool adds_up() { return true; }
    FoundPhotons nearest(const PhotonQuery& query) const
    {
        return find_photons(maps, surfaces.partition, query, scratch.search);
    }
    FoundSum nearest_sum(const PhotonQuery& query) const
    {
        return sum_photons(maps, surfaces.partition, query, scratch.search);
    }
    template <typename Accept>
    FoundPhotons accepted(const PhotonQuery& query, const Accept& accept) const
    {
        return find_accepted(maps, surfaces.partition, query, accept, scratch.search.accepted);
    }
    SearchStatistics counted() const { return scratch.search.statistics; }
    void recount(const SearchStatistics& counted) const { scratch.search.statistics = counted; }
};

/// [map] 1: the normals of its faces do not lie within 45 degrees of their mean.
std::vector<std::uint8_t> find_folds(const Partition& partition,
                                     const std::vector<glm::vec3>& normals)
{
    std::vector<glm::dvec3> mean(partition.map_count, glm::dvec3(0));
    for (FaceId face = 0; face < normals.size(); ++face)
        if (const MapId map = partition.map_of(face); map != kNone)
            mean[map] += glm::dvec3(normals[face]);
    std::vector<std::uint8_t> out(partition.map_count, 0);
    for (FaceId face = 0; face < normals.size(); ++face)
        if (const MapId map = partition.map_of(face); map != kNone) {
            const double along = glm::dot(glm::dvec3(normals[face]), mean[map]);
            if (!(along > glm::length(mean[map]) / std::numbers::sqrt2))
                out[map] = 1;
        }
    return out;
}

} // namespace

MapSurfaces::MapSurfaces(const TriangleMesh& of_mesh, const Partition& of_partition)
    : mesh(of_mesh), partition(of_partition), boundaries(of_mesh, of_partition),
      own_boundaries(of_partition)
{
    normals.reserve(mesh.face_count());
    std::vector<double> area(partition.map_count, 0.0);
    std::vector<glm::dvec3> vectors(partition.map_count, glm::dvec3(0));
    for (FaceId face = 0; face < mesh.face_count(); ++face) {
        const glm::dvec3 normal = scaled_normal(mesh, face);
        const double length = glm::length(normal);
        const double sign = partition.is_flipped(face) ? -1 : 1;
        normals.push_back(length > 0 ? glm::vec3(normal * (sign / length)) : glm::vec3(0));
        if (const MapId map = partition.map_of(face); map != kNone) {
            area[map] += length / 2;
            vectors[map] += normal * (sign / 2);
        }
    }
    map_area.assign(area.begin(), area.end());
    vector_area.assign(vectors.begin(), vectors.end());
    folds = find_folds(partition, normals);
}

double MapSurfaces::facing_area(FaceId face) const
{
    const glm::dvec3 normal(normals[mesh.stored_face(face)]);
    const MapId map = partition.map_of_face[partition.stored_face(face)];
    const double along = glm::dot(normal, glm::dvec3(vector_area[map]));
    const double area = map_area[map];
    const double facing = std::min(area, std::max(along, area / 2 + 3 * along / 4));
    return facing * (area_at(face) / area);
}

float even_radius(const PhotonMaps& maps, const MapSurfaces& surfaces, const PhotonQuery& query)
{
    if (surfaces.partition.map_of(query.face) == kNone)
        return std::numeric_limits<float>::infinity();
    const PhotonMap* map = map_of_query(maps, surfaces.partition, query);
    if (map == nullptr)
        return std::numeric_limits<float>::infinity();
    return filter_radius(surfaces.area_at(query.face), maps.options.neighbours, map->tree.size);
}

Rgb estimate_irradiance(const PhotonMaps& maps, const MapSurfaces& surfaces,
                        const PhotonQuery& query, EstimateScratch& scratch)
{
    return clipped_estimate(SharedSearch{maps, surfaces, scratch}, query);
}

} // namespace hipmap
