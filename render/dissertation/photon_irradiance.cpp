#include "render/dissertation/photon_irradiance.h"

#include "render/dissertation/level_search.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cassert>
#include <numbers>

namespace hipmap {

namespace {

/// Cosine of the angle up to which two surfaces face the same way.
constexpr float kSameWay = std::numbers::sqrt2_v<float> / 2;

/// Returns the normal of the side of its face that the photon's light fell on.
glm::vec3 normal_of(const DissertationMaps& maps, const PhotonMap& map, std::uint32_t slot,
                    const MapSurfaces& surfaces)
{
    const glm::vec3& normal = surfaces.normals[map.faces[slot]];
    const bool sides_apart = !maps.one_map() && maps.sides() == 2;
    const bool front = sides_apart ? map.side == 0 : glm::dot(map.direction(slot), normal) >= 0;
    return front ? normal : -normal;
}

/// Where the estimate for a photon is made.
PhotonQuery query_at(const DissertationMaps& maps, const PhotonMap& map, std::uint32_t slot,
                     const MapSurfaces& surfaces, bool bounded)
{
    PhotonQuery query{map.tree.position(slot), normal_of(maps, map, slot, surfaces),
                      map.faces[slot], map.side};
    if (bounded)
        query.radius = dissertation::even_radius(maps, surfaces, query);
    return query;
}

PhotonIrradiance::Map estimate_in_map(const DissertationMaps& maps, const PhotonMap& map,
                                      const MapSurfaces& surfaces, const IrradianceOptions& options)
{
    std::vector<TreePoint> points = every_nth_photon(map.tree, options.photons_each);
    PhotonIrradiance::Map out;
    out.tree = build_wide_tree(points);
    out.irradiance.resize(points.size());
    out.normals.resize(points.size());
    using Range = tbb::blocked_range<std::size_t>;
    tbb::parallel_for(Range(0, points.size(), 256), [&](const Range& range) {
        ChosenScratch scratch;
        for (std::size_t i = range.begin(); i < range.end(); ++i) {
            const PhotonQuery query =
                query_at(maps, map, points[i].photon, surfaces, options.bounded);
            out.normals[i] = query.normal;
            out.irradiance[i] = dissertation::estimate_irradiance(maps, surfaces, query, scratch);
        }
    });
    return out;
}

} // namespace

PhotonIrradiance estimate_at_photons(const DissertationMaps& maps, const MapSurfaces& surfaces,
                                     const IrradianceOptions& options)
{
    assert(options.photons_each >= 1);
    PhotonIrradiance out;
    for (const PhotonMap& map : maps.shared.maps)
        out.maps.push_back(estimate_in_map(maps, map, surfaces, options));
    return out;
}

std::optional<Rgb> nearest_irradiance(const PhotonIrradiance& irradiance,
                                      const DissertationMaps& maps, const Partition& partition,
                                      const PhotonQuery& query, TreeScratch& scratch)
{
    const PhotonMap* const read = map_of_query(maps, partition, query);
    if (read == nullptr)
        return {};
    const PhotonIrradiance::Map& map =
        irradiance.maps[static_cast<std::size_t>(read - maps.shared.maps.data())];
    const FoundSlots found =
        find_nearest(map.tree, {query.position, 1}, scratch, [&](std::uint32_t slot) {
            return glm::dot(map.normals[slot], query.normal) > kSameWay;
        });
    if (found.slots.empty())
        return {};
    return map.irradiance[found.slots[0]];
}

} // namespace hipmap
