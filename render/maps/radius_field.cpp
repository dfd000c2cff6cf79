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

/// Returns the part of a radius that is left where photons are dense, docs/photon_maps.md (11).
float part_where_dense(float radius, float even_radius)
{
    constexpr float kLeast = 0.25f; // of the square
    return std::sqrt(std::clamp(radius / even_radius, kLeast, 1.0f));
}

/// Returns the part of a radius that is left where the photons found lie to one side of the point,
/// as at an edge of light, docs/photon_maps.md (12).
float part_at_edge(const WideTree& tree, const glm::vec3& point, const FoundSlots& found)
{
    constexpr float kLeast = 0.3f;
    constexpr float kAtEdge2 = 0.09f; // half of m^2 at a straight edge
    glm::vec3 sum(0);
    for (const std::uint32_t slot : found.slots)
        sum += tree.position(slot) - point;
    const auto count = static_cast<float>(found.slots.size());
    const float scale2 = count * count * found.farthest2;
    if (!(scale2 > 0)) // all in one place
        return 1;
    const float m2 = glm::dot(sum, sum) / scale2 - 1 / (2 * count);
    return 1 - (1 - kLeast) * std::clamp(m2 / kAtEdge2, 0.0f, 1.0f);
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

RadiusField::Map build_radius_map(const MapOfRadii& map, const MapSurfaces& surfaces,
                                  const std::function<NearestSearch()>& make_search)
{
    const PhotonMap& photons = map.photons;
    RadiusField::Map out;
    out.even_radius = filter_radius(map.area, map.neighbours, photons.tree.size);
    std::vector<TreePoint> points = every_nth_photon(photons.tree, kPhotonsOfRadius);
    out.sparse = photons.tree.size < map.neighbours;
    out.tree = build_wide_tree(points);
    out.radius.resize(points.size());
    using Range = tbb::blocked_range<std::size_t>;
    tbb::parallel_for(Range(0, points.size(), 256), [&](const Range& range) {
        const NearestSearch find = make_search();
        for (std::size_t i = range.begin(); i < range.end(); ++i) {
            const glm::vec3& point = points[i].position;
            const FoundSlots found =
                find({point, map.neighbours, out.even_radius * out.even_radius});
            const bool enough = found.slots.size() == map.neighbours;
            const float reach = enough ? std::sqrt(found.farthest2) : out.even_radius;
            const FaceId face = photons.faces[points[i].photon];
            const float radius = narrowed_to_surface(surfaces, face, point, reach);
            float part = 1;
            if (map.sharp)
                part = part_where_dense(radius, out.even_radius) *
                       (enough ? part_at_edge(photons.tree, point, found) : 1);
            out.radius[i] = radius * part;
        }
    });
    return out;
}

RadiusField build_radius_field(const PhotonMaps& photons, const MapSurfaces& surfaces,
                               const RadiusField::Rules& rules)
{
    RadiusField out;
    out.sparse = rules.sparse;
    out.index.options = photons.options;
    out.index.map_of = photons.map_of;
    out.index.held = photons.held;
    for (const PhotonMap& map : photons.maps)
        out.maps.push_back(build_radius_map(
            {map, surfaces.area_at(map.faces[0]), photons.options.neighbours, rules.sharp},
            surfaces, [&map] {
                return [&map, scratch = TreeScratch()](const TreeQuery& query) mutable {
                    return find_nearest(map.tree, query, scratch);
                };
            }));
    return out;
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
