#include "render/dissertation/map_levels.h"
#include "render/maps/photon_groups.h"

#include <tbb/parallel_for.h>

namespace hipmap {

namespace {

/// Photons, and the slots of each in its shared map.
struct Placed {
    const std::vector<Photon>& photons;
    const std::vector<std::uint32_t>& slot_of; ///< [photons]
};

/// What local maps are of: faces, or groups of them.
struct LocalKeys {
    const std::vector<std::uint32_t>& of_face; ///< [F] below `count`; kNone: never a map
    std::size_t count;
};

/// points: of the photons of the map.  area: of their faces, square scene units.
LocalMap build_local_map(const DissertationMaps& maps, const Placed& placed,
                         std::span<TreePoint> points, double area)
{
    LocalMap local;
    if (maps.options.tree == TreeKind::wide) {
        local.tree = build_wide_tree(points);
        local.powers = build_powers(local.tree, points, placed.photons, maps.shared.power_scale);
    } else {
        local.kd_tree = build_kd_tree(maps.options.tree, points);
    }
    for (const TreePoint& point : points)
        local.shared_slots.push_back(placed.slot_of[point.photon]);
    local.filter_radius = filter_radius(area, maps.shared.options.neighbours, points.size());
    return local;
}

/// Algorithm 3 of the thesis: every face, or group, keeps references to its photons; then those
/// with fewer than local_min lose their map, the others get their filter radius.
LocalMaps build_maps_of(const DissertationMaps& maps, const Placed& placed,
                        const TriangleMesh& mesh, const LocalKeys& wanted)
{
    const std::size_t keys = maps.sides() * wanted.count; // and one for what never has a map
    const auto key_of = [&](FaceId face, std::uint8_t side) {
        const std::uint32_t key = wanted.of_face[face];
        return key == kNone ? keys : maps.index_by_side(key, side);
    };
    PhotonGroups groups = group_photons(placed.photons, keys + 1, [&](const Photon& photon) {
        return key_of(photon.face, photon.side);
    });
    std::vector<std::uint32_t> local_of_key(keys + 1, kNone);
    std::vector<std::size_t> key_of_local;
    for (std::size_t key = 0; key < keys; ++key) {
        const std::size_t count = groups.of(key).size();
        if (count == 0 || count < maps.options.local_min)
            continue;
        local_of_key[key] = static_cast<std::uint32_t>(key_of_local.size());
        key_of_local.push_back(key);
    }
    LocalMaps out;
    std::vector<double> area(keys + 1, 0.0);
    for (FaceId face = 0; face < mesh.face_count(); ++face)
        for (std::uint8_t side = 0; side < maps.sides(); ++side) {
            out.of_face.push_back(local_of_key[key_of(face, side)]);
            area[key_of(face, side)] += face_area(mesh, face);
        }
    out.maps.resize(key_of_local.size());
    tbb::parallel_for(std::size_t{0}, out.maps.size(), [&](std::size_t i) {
        const std::size_t key = key_of_local[i];
        out.maps[i] = build_local_map(maps, placed, groups.of(key), area[key]);
    });
    return out;
}

} // namespace

void build_local_maps(DissertationMaps& maps, const std::vector<Photon>& photons,
                      const std::vector<std::uint32_t>& slot_of, const MapSurfaces& surfaces)
{
    const TriangleMesh& mesh = surfaces.mesh;
    const Partition& partition = surfaces.partition;
    const bool thesis = maps.options.mode == MapMode::thesis;
    std::vector<std::uint32_t> faces(mesh.face_count(), kNone);
    for (FaceId face = 0; face < mesh.face_count(); ++face)
        if (thesis || partition.candidate[face])
            faces[face] = face;
    const Placed placed{photons, slot_of};
    maps.locals = build_maps_of(maps, placed, mesh, {faces, mesh.face_count()});
    if (!thesis)
        maps.groups =
            build_maps_of(maps, placed, mesh, {partition.group_of_face, partition.group_count});
}

} // namespace hipmap
