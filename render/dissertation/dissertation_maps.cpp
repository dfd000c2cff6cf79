#include "render/dissertation/dissertation_maps.h"

#include "render/dissertation/map_levels.h"
#include "render/maps/photon_groups.h"

#include <tbb/parallel_for.h>

#include <numeric>

namespace hipmap {

namespace {

/// The square scene units of all faces that have a map.
float area_of_maps(const TriangleMesh& mesh, const Partition& partition)
{
    std::vector<double> area(partition.map_count, 0.0);
    for (FaceId face = 0; face < mesh.face_count(); ++face)
        if (const MapId map = partition.map_of_face[face]; map != kNone)
            area[map] += glm::length(scaled_normal(mesh, face)) / 2;
    return static_cast<float>(std::accumulate(area.begin(), area.end(), 0.0));
}

/// The maps of the photons' groups, and where each group's map is among them; kNone: it has no
/// photon.
std::vector<std::uint32_t>
build_grouped_maps(DissertationMaps& maps, const std::vector<Photon>& photons, PhotonGroups& groups)
{
    const std::size_t keys = groups.first.size() - 1;
    std::vector<std::uint32_t> map_of_key(keys, kNone);
    std::vector<std::size_t> key_of_map;
    for (std::size_t key = 0; key < keys; ++key) {
        if (groups.of(key).empty())
            continue;
        map_of_key[key] = static_cast<std::uint32_t>(key_of_map.size());
        key_of_map.push_back(key);
    }
    PhotonMaps& shared = maps.shared;
    const TreeKind kind = maps.options.tree;
    shared.maps.resize(key_of_map.size());
    maps.kd_trees.resize(kind == TreeKind::wide ? 0 : key_of_map.size());
    tbb::parallel_for(std::size_t{0}, shared.maps.size(), [&](std::size_t m) {
        const std::span<TreePoint> points = groups.of(key_of_map[m]);
        if (kind != TreeKind::wide)
            maps.kd_trees[m] = build_kd_tree(kind, points);
        shared.maps[m] =
            pack_photons(kind == TreeKind::wide ? build_wide_tree(points) : build_blocks(points),
                         points, photons, {shared.power_scale, shared.options.directions});
    });
    return map_of_key;
}

/// Returns the photons' numbers in the order of the trees.
PhotonGroups build_shared_maps(DissertationMaps& maps, const std::vector<Photon>& photons,
                               const Partition& partition)
{
    const auto key_of = [&](MapId map, std::uint8_t side) {
        return maps.one_map() ? 0 : maps.index_by_side(map, side);
    };
    const std::size_t keys = maps.one_map() ? 1 : std::size_t{maps.sides()} * partition.map_count;
    PhotonGroups groups = group_photons(photons, keys, [&](const Photon& photon) {
        return key_of(partition.map_of_face[photon.face], photon.side);
    });
    const std::vector<std::uint32_t> map_of_key = build_grouped_maps(maps, photons, groups);
    maps.shared.map_of.resize(std::size_t{2} * partition.map_count);
    for (MapId map = 0; map < partition.map_count; ++map)
        for (std::uint8_t side = 0; side < 2; ++side)
            maps.shared.map_of[PhotonMaps::map_index(map, side)] = map_of_key[key_of(map, side)];
    return groups;
}

/// The slots of the photons in their shared maps, by number.
std::vector<std::uint32_t> slots_by_number(const PhotonGroups& shared)
{
    std::vector<std::uint32_t> slot_of(shared.points.size());
    for (std::size_t key = 0; key + 1 < shared.first.size(); ++key)
        for (std::size_t i = shared.first[key]; i < shared.first[key + 1]; ++i)
            slot_of[shared.points[i].photon] = static_cast<std::uint32_t>(i - shared.first[key]);
    return slot_of;
}

} // namespace

DissertationMaps build_dissertation_maps(const std::vector<Photon>& photons,
                                         const MapSurfaces& surfaces, const MapOptions& options,
                                         const DissertationOptions& asked)
{
    check_photon_count(photons);
    const Partition& partition = surfaces.partition;
    DissertationMaps maps;
    maps.options = asked;
    PhotonMaps& shared = maps.shared;
    shared.options = options;
    // Of one map, and by the thesis' estimate, photons are told apart by where they came from.
    if (maps.one_map() || asked.estimate == EstimateForm::thesis)
        shared.options.directions = true;
    shared.size = photons.size();
    maps.total_area = area_of_maps(surfaces.mesh, partition);
    if (photons.empty())
        return maps;
    shared.power_scale = power_scale(photons);
    const PhotonGroups groups = build_shared_maps(maps, photons, partition);
    const bool planned = asked.mode == MapMode::hierarchical;
    if (asked.mode == MapMode::thesis || (planned && asked.tree != TreeKind::wide))
        build_local_maps(maps, photons, slots_by_number(groups), surfaces);
    else if (planned)
        build_levels(maps, surfaces);
    if (asked.irradiance == GatheredIrradiance::precomputed)
        maps.irradiance = estimate_at_photons(maps, surfaces, {});
    return maps;
}

} // namespace hipmap
