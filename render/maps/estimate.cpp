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

/// [F] towards side 0.
std::vector<glm::vec3> find_normals(const TriangleMesh& mesh, const Partition& partition)
{
    std::vector<glm::vec3> out;
    out.reserve(mesh.face_count());
    for (FaceId face = 0; face < mesh.face_count(); ++face) {
        const glm::dvec3 normal = scaled_normal(mesh, face);
        const double length = glm::length(normal);
        const double sign = partition.is_flipped(face) ? -1 : 1;
        out.push_back(length > 0 ? glm::vec3(normal * (sign / length)) : glm::vec3(0));
    }
    return out;
}

/// [map]
std::vector<float> find_areas(const TriangleMesh& mesh, const Partition& partition)
{
    std::vector<double> area(partition.map_count, 0.0);
    for (FaceId face = 0; face < mesh.face_count(); ++face)
        if (const MapId map = partition.map_of(face); map != kNone)
            area[map] += face_area(mesh, face);
    return {area.begin(), area.end()};
}

/// [map] a number, from 0 on, where the normals of its faces do not lie within 45 degrees of their
/// mean; else kNone.
std::vector<std::uint32_t> find_folds(const Partition& partition,
                                      const std::vector<glm::vec3>& normals)
{
    std::vector<glm::dvec3> mean(partition.map_count, glm::dvec3(0));
    for (FaceId face = 0; face < normals.size(); ++face)
        if (const MapId map = partition.map_of(face); map != kNone)
            mean[map] += glm::dvec3(normals[face]);
    std::vector<std::uint32_t> out(partition.map_count, kNone);
    std::uint32_t folds = 0;
    for (FaceId face = 0; face < normals.size(); ++face)
        if (const MapId map = partition.map_of(face); map != kNone) {
            const double along = glm::dot(glm::dvec3(normals[face]), mean[map]);
            if (out[map] == kNone && !(along > glm::length(mean[map]) / std::numbers::sqrt2))
                out[map] = folds++;
        }
    return out;
}

} // namespace

MapSurfaces::MapSurfaces(const TriangleMesh& of_mesh, const Partition& of_partition)
    : mesh(of_mesh), partition(of_partition), boundaries(of_mesh, of_partition),
      own_boundaries(of_partition), normals(find_normals(of_mesh, of_partition)),
      map_area(find_areas(of_mesh, of_partition)), fold_of(find_folds(of_partition, normals)),
      folds(build_fold_trees(of_mesh, of_partition, fold_of))
{
}

FoldAreas MapSurfaces::facing_areas(FaceId face, const glm::vec3& point,
                                    std::span<const float> radii, AreaOf of) const
{
    const FaceId stored = mesh.stored_face(face);
    FoldQuery query{fold_of[partition.map_of_face[partition.stored_face(face)]], point,
                    normals[stored], of};
    if (!mesh.is_copied(face)) [[likely]]
        return fold_areas(folds, query, radii);
    const Similarity& place = mesh.copy_of(face).place;
    query.point = glm::vec3(place.point_back(glm::dvec3(point)));
    std::array<float, kMostFoldRadii> stored_radii{};
    std::ranges::transform(radii, stored_radii.begin(),
                           [&](float r) { return static_cast<float>(r / place.scale); });
    FoldAreas out = fold_areas(folds, query, std::span(stored_radii).first(radii.size()));
    for (double& area : out)
        area *= place.scale * place.scale;
    return out;
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
