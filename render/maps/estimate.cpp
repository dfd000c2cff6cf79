#include "render/maps/estimate.h"

#include "common/math/bounds.h"
#include "common/math/frame.h"
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

/// Calls use(face, place of its map's box) for all faces of maps that may fold.
template <typename Use>
void for_each_folding(const MapSurfaces& surfaces, const Use& use)
{
    for (FaceId face = 0; face < surfaces.mesh.face_count(); ++face)
        if (surfaces.partition.map_of(face) != kNone && surfaces.may_fold(face))
            use(face, surfaces.fold_of[surfaces.partition.map_of(face)]);
}

/// The largest face looks along one axis, the largest of those that look aside along another.
void turn_boxes(const MapSurfaces& surfaces, std::vector<FoldBox>& boxes)
{
    constexpr float kAside = 0.5f; // sine of the angle to the first axis
    for (const int axis : {0, 1}) {
        std::vector<double> largest(boxes.size(), 0.0);
        for_each_folding(surfaces, [&](FaceId face, std::uint32_t place) {
            const double area = face_area(surfaces.mesh, face);
            glm::mat3& axes = boxes[place].axes;
            glm::vec3 normal = surfaces.normals[face];
            if (axis == 1)
                normal -= glm::dot(normal, axes[0]) * axes[0];
            if (area <= largest[place] || (axis == 1 && glm::length(normal) < kAside))
                return;
            largest[place] = area;
            axes[axis] = glm::normalize(normal);
            if (axis == 0) // until there is a face to the side
                axes[1] = Frame(axes[0]).x;
            axes[2] = glm::cross(axes[0], axes[1]);
        });
    }
}

std::vector<FoldBox> find_boxes(const MapSurfaces& surfaces)
{
    const auto count = static_cast<std::size_t>(std::ranges::count_if(
        surfaces.fold_of, [](std::uint32_t place) { return place != kNone; }));
    std::vector<FoldBox> out(count);
    turn_boxes(surfaces, out);
    std::vector<Bounds<glm::vec3>> bounds(count);
    for_each_folding(surfaces, [&](FaceId face, std::uint32_t place) {
        for (const glm::vec3& corner : surfaces.mesh.triangle(face))
            bounds[place].add(glm::transpose(out[place].axes) * corner);
    });
    for (std::size_t i = 0; i < count; ++i)
        out[i].extent = bounds[i].extent();
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
    fold_of = find_folds(partition, normals);
    fold_boxes = find_boxes(*this);
}

float MapSurfaces::widest_radius(FaceId face) const
{
    const FaceId stored = mesh.stored_face(face);
    const std::uint32_t place = fold_of[partition.map_of_face[partition.stored_face(face)]];
    if (place == kNone)
        return std::numeric_limits<float>::infinity();
    const FoldBox& box = fold_boxes[place];
    // The face looks along the axis that is nearest to its normal, and sees the other two.
    const int most = longest_axis(glm::abs(glm::transpose(box.axes) * normals[stored]));
    const float width = std::min(box.extent[(most + 1) % 3], box.extent[(most + 2) % 3]);
    const double scale = mesh.is_copied(face) ? mesh.copy_of(face).place.scale : 1.0;
    return static_cast<float>(0.5 * width * scale);
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
