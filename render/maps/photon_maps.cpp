#include "render/maps/photon_maps.h"

#include "common/input_error.h"
#include "render/maps/hierarchical.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

namespace hipmap {

namespace {

/// Photons by key, in a stable order.
struct Groups {
    std::vector<TreePoint> points;
    std::vector<std::uint64_t> first; ///< [keys + 1]: group g is points [first[g], first[g+1])

    std::span<TreePoint> of(std::size_t key)
    {
        return {points.data() + first[key], static_cast<std::size_t>(first[key + 1] - first[key])};
    }
};

/// key_of(photon) < key_count.  A counting sort.
template <typename KeyOf>
Groups group_by_key(const std::vector<Photon>& photons, std::size_t key_count, const KeyOf& key_of)
{
    Groups groups;
    groups.first.assign(key_count + 1, 0);
    for (const Photon& photon : photons)
        ++groups.first[key_of(photon) + 1];
    for (std::size_t k = 0; k < key_count; ++k)
        groups.first[k + 1] += groups.first[k];
    std::vector<std::uint64_t> next(groups.first.begin(), groups.first.end() - 1);
    groups.points.resize(photons.size());
    for (std::size_t i = 0; i < photons.size(); ++i)
        groups.points[next[key_of(photons[i])]++] = {photons[i].position,
                                                     static_cast<std::uint32_t>(i)};
    return groups;
}

/// For a map's own photons; `wide` then has their positions, whatever is searched.
void build_tree(TreeKind kind, std::span<TreePoint> points, WideTree& wide, KdTree& kd)
{
    if (kind == TreeKind::wide) {
        wide = build_wide_tree(points);
        return;
    }
    kd = build_kd_tree(kind, points);
    wide = build_blocks(points);
}

PhotonMap build_map(const PhotonMaps& maps, const std::vector<Photon>& photons,
                    std::span<TreePoint> points)
{
    PhotonMap map;
    build_tree(maps.options.tree, points, map.tree, map.kd_tree);
    map.powers = build_powers(map.tree, points, photons, maps.power_scale);
    map.faces.resize(points.size());
    map.directions.resize(maps.options.keep_directions() ? points.size() : 0);
    tbb::parallel_for(std::size_t{0}, points.size(), [&](std::size_t slot) {
        const Photon& photon = photons[points[slot].photon];
        map.faces[slot] = photon.face;
        if (!map.directions.empty())
            map.directions[slot] = pack_direction(photon.direction);
    });
    map.side = photons[points[0].photon].side;
    return map;
}

/// Returns the photons' numbers in the order of the trees.
Groups build_shared_maps(PhotonMaps& maps, const std::vector<Photon>& photons,
                         const Partition& partition)
{
    const bool one_map = maps.options.mode == MapMode::global;
    const std::size_t keys = one_map ? 1 : std::size_t{maps.sides()} * partition.map_count;
    Groups groups = group_by_key(photons, keys, [&](const Photon& photon) {
        return maps.map_index(partition.map_of_face[photon.face], photon.side);
    });
    maps.map_of.assign(keys, kNone);
    std::vector<std::size_t> key_of_map;
    for (std::size_t key = 0; key < keys; ++key) {
        if (groups.of(key).empty())
            continue;
        maps.map_of[key] = static_cast<std::uint32_t>(key_of_map.size());
        key_of_map.push_back(key);
    }
    maps.maps.resize(key_of_map.size());
    tbb::parallel_for(std::size_t{0}, maps.maps.size(), [&](std::size_t m) {
        maps.maps[m] = build_map(maps, photons, groups.of(key_of_map[m]));
    });
    return groups;
}

/// The slots of the photons in their shared maps, by number.
std::vector<std::uint32_t> slots_by_number(const Groups& shared)
{
    std::vector<std::uint32_t> slot_of(shared.points.size());
    for (std::size_t key = 0; key + 1 < shared.first.size(); ++key)
        for (std::size_t i = shared.first[key]; i < shared.first[key + 1]; ++i)
            slot_of[shared.points[i].photon] = static_cast<std::uint32_t>(i - shared.first[key]);
    return slot_of;
}

/// What local maps are of: faces, or groups of them.
struct LocalKeys {
    const std::vector<std::uint32_t>& of_face; ///< [F] below `count`; kNone: never a map
    std::size_t count;
};

/// Algorithm 3 of the thesis: every face, or group, keeps references to its photons; then those
/// with fewer than local_min lose their map, the others get their filter radius.
LocalMaps build_local_maps(const PhotonMaps& maps, const std::vector<Photon>& photons,
                           const std::vector<std::uint32_t>& slot_of, const TriangleMesh& mesh,
                           const LocalKeys& wanted)
{
    const std::size_t keys = maps.sides() * wanted.count; // and one for what never has a map
    const auto key_of = [&](FaceId face, std::uint8_t side) {
        const std::uint32_t key = wanted.of_face[face];
        return key == kNone ? keys : maps.index_by_side(key, side);
    };
    Groups groups = group_by_key(
        photons, keys + 1, [&](const Photon& photon) { return key_of(photon.face, photon.side); });
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
        const std::span<TreePoint> points = groups.of(key_of_local[i]);
        LocalMap& local = out.maps[i];
        if (maps.options.tree == TreeKind::wide) {
            local.tree = build_wide_tree(points);
            local.powers = build_powers(local.tree, points, photons, maps.power_scale);
        } else {
            local.kd_tree = build_kd_tree(maps.options.tree, points);
        }
        for (const TreePoint& point : points)
            local.shared_slots.push_back(slot_of[point.photon]);
        local.filter_radius =
            filter_radius(area[key_of_local[i]], maps.options.neighbours, points.size());
    });
    return out;
}

/// Maps of faces and of groups by reference: the thesis' local maps, and the tiers of mode
/// hierarchical on kd-trees, no part of which is a tree for them.
void build_copied_tiers(PhotonMaps& maps, const std::vector<Photon>& photons, const Groups& shared,
                        const TriangleMesh& mesh, const Partition& partition)
{
    const bool thesis = maps.options.mode == MapMode::thesis;
    const std::vector<std::uint32_t> slot_of = slots_by_number(shared);
    std::vector<std::uint32_t> faces(mesh.face_count(), kNone);
    for (FaceId face = 0; face < mesh.face_count(); ++face)
        if (thesis || partition.candidate[face])
            faces[face] = face;
    maps.locals = build_local_maps(maps, photons, slot_of, mesh, {faces, mesh.face_count()});
    if (!thesis)
        maps.groups = build_local_maps(maps, photons, slot_of, mesh,
                                       {partition.group_of_face, partition.group_count});
}

} // namespace

float filter_radius(double area, std::uint32_t neighbours, std::uint64_t photons)
{
    if (photons == 0)
        return std::numeric_limits<float>::infinity();
    return static_cast<float>(
        std::sqrt(area * neighbours / (std::numbers::pi * static_cast<double>(photons))));
}

std::size_t PhotonMaps::bytes() const
{
    std::size_t sum = map_of.size() * sizeof(std::uint32_t);
    for (const PhotonMap& map : maps)
        sum += sizeof(PhotonMap) + map.bytes();
    return sum;
}

std::uint64_t PhotonMaps::largest_map() const
{
    std::uint64_t largest = 0;
    for (const PhotonMap& map : maps)
        largest = std::max(largest, map.tree.size);
    return largest;
}

PhotonMaps build_photon_maps(const std::vector<Photon>& photons, const TriangleMesh& mesh,
                             const Partition& partition, const MapOptions& options)
{
    if (photons.size() > std::numeric_limits<std::uint32_t>::max())
        throw InputError("a pass stores " + std::to_string(photons.size()) +
                         " photons of one kind, more than 4294967295; ask for fewer --photons");
    PhotonMaps maps;
    maps.options = options;
    maps.size = photons.size();
    if (photons.empty())
        return maps;
    maps.power_scale = power_scale(photons);
    const Groups groups = build_shared_maps(maps, photons, partition);
    const bool tiers = options.mode == MapMode::hierarchical;
    if (options.mode == MapMode::thesis || (tiers && options.tree != TreeKind::wide))
        build_copied_tiers(maps, photons, groups, mesh, partition);
    else if (tiers)
        build_tiers(maps, mesh, partition);
    return maps;
}

} // namespace hipmap
