#include "render/maps/radius_field.h"

#include "render/maps/gather.h"
#include "render/maps/wide_search.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace hipmap {

namespace {

/// Returns the part of the square of the way to the nearest photon that counts in the square of a
/// radius, docs/photon_maps.md (10): beside dense photons, as those of a caustic, a radius that
/// reaches them would light the dark around them.
float part_of_way(float radius, float even_radius)
{
    constexpr float kLeast = 0.25f, kDense = 0.5f;
    const float part = radius / (kDense * even_radius);
    return std::clamp(part * part, kLeast, 1.0f);
}

/// Returns the radius (> 0) at a point of a face, narrowed until most of the disc lies on the
/// surface, docs/visible_area.md (A10).
float narrowed_to_surface(const MapSurfaces& surfaces, FaceId face, const glm::vec3& point,
                          float radius)
{
    constexpr double kMost = 0.8;
    constexpr int kSteps = 4;
    for (int step = 0; step < kSteps && surfaces.may_fold(face); ++step) {
        const double on_surface =
            surfaces.facing_areas(face, point, {&radius, 1}, AreaOf::projection)[0];
        const double part = on_surface / disc_area(radius);
        if (!(part > 0) || part >= kMost)
            break;
        radius *= static_cast<float>(std::sqrt(part));
    }
    return radius;
}

} // namespace

RadiusField::Map build_radius_map(const PhotonMap& photons, std::uint32_t neighbours,
                                  const MapSurfaces& surfaces, float area,
                                  const std::function<NearestSearch()>& make_search)
{
    RadiusField::Map out;
    out.even_radius = filter_radius(area, neighbours, photons.tree.size);
    std::vector<TreePoint> points = every_nth_photon(photons.tree, kPhotonsOfRadius);
    out.sparse = photons.tree.size < neighbours;
    out.tree = build_wide_tree(points);
    out.radius.resize(points.size());
    using Range = tbb::blocked_range<std::size_t>;
    tbb::parallel_for(Range(0, points.size(), 256), [&](const Range& range) {
        const NearestSearch find = make_search();
        for (std::size_t i = range.begin(); i < range.end(); ++i) {
            const float most2 = out.even_radius * out.even_radius;
            const FoundSlots found = find({points[i].position, neighbours, most2});
            const float radius =
                found.slots.size() == neighbours ? std::sqrt(found.farthest2) : out.even_radius;
            out.radius[i] = narrowed_to_surface(surfaces, photons.faces[points[i].photon],
                                                points[i].position, radius);
        }
    });
    return out;
}

RadiusField build_radius_field(const PhotonMaps& photons, const MapSurfaces& surfaces,
                               RadiusField::Sparse sparse)
{
    RadiusField out;
    out.sparse = sparse;
    out.index.options = photons.options;
    out.index.map_of = photons.map_of;
    out.index.held = photons.held;
    for (const PhotonMap& map : photons.maps)
        out.maps.push_back(build_radius_map(
            map, photons.options.neighbours, surfaces, surfaces.area_at(map.faces[0]), [&map] {
                return [&map, scratch = TreeScratch()](const TreeQuery& query) mutable {
                    return find_nearest(map.tree, query, scratch);
                };
            }));
    return out;
}

void narrow_where_dense(RadiusField& field)
{
    constexpr float kLeast = 0.25f; // of the square
    for (RadiusField::Map& map : field.maps)
        for (float& radius : map.radius)
            radius *= std::sqrt(std::clamp(radius / map.even_radius, kLeast, 1.0f));
}

float radius_at(const RadiusField& field, const MapSurfaces& surfaces, const PhotonQuery& query)
{
    const MapId id = surfaces.partition.map_of(query.face);
    if (id == kNone)
        return std::numeric_limits<float>::infinity();
    const std::uint32_t place = field.index.place(id, query.side);
    if (field.sparse == RadiusField::Sparse::infinite &&
        (place == kNone || field.maps[place].sparse))
        return std::numeric_limits<float>::infinity();
    if (place == kNone) // as if there were one photon
        return filter_radius(surfaces.area_at(query.face), field.index.options.neighbours, 1);
    const RadiusField::Map& map = field.maps[place];
    if (tree_search::is_nowhere(query.position))
        return map.even_radius;
    const NearPhoton near = near_photon(map.tree, query.position);
    // Away from all photons it grows with the way to them.
    const float radius = map.radius[near.slot];
    const float way2 = part_of_way(radius, map.even_radius) * near.distance2;
    return std::min(map.even_radius, std::sqrt(radius * radius + way2));
}

} // namespace hipmap
