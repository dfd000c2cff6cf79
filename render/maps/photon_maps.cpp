#include "render/maps/photon_maps.h"

#include "common/input_error.h"
#include "render/maps/hierarchical.h"

#include <tbb/parallel_for.h>

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

std::vector<float> areas_of_maps(const PhotonMaps& maps, const TriangleMesh& mesh,
                                 const Partition& partition, std::size_t map_count)
{
    std::vector<double> area(map_count, 0.0);
    for (FaceId face = 0; face < mesh.face_count(); ++face) {
        if (partition.map_of_face[face] == kNone)
            continue;
        const MapId map = partition.map_of_face[face];
        area[maps.map_index(map, 0)] += face_area(mesh, face);
        area[maps.map_index(map, 1)] = area[maps.map_index(map, 0)];
    }
    return {area.begin(), area.end()};
}

/// Returns the photons' numbers in the order of the trees.
Groups build_trees(PhotonMaps& maps, const std::vector<Photon>& photons, const Partition& partition)
{
    const std::size_t map_count = maps.map_area.size();
    Groups groups = group_by_key(photons, map_count, [&](const Photon& photon) {
        return maps.map_index(partition.map_of_face[photon.face], photon.side);
    });
    maps.trees.resize(map_count);
    tbb::parallel_for(std::size_t{0}, map_count,
                      [&](std::size_t m) { maps.trees[m] = build_wide_tree(groups.of(m)); });
    maps.first_photon = groups.first;
    maps.photons.resize(photons.size());
    tbb::parallel_for(std::size_t{0}, photons.size(),
                      [&](std::size_t i) { maps.photons[i] = photons[groups.points[i].photon]; });
    return groups;
}

/// Algorithm 3 of the thesis: every face keeps references to its photons; then faces with fewer
/// than local_min lose their map, the others get their filter radius.
void build_local_maps(PhotonMaps& maps, const std::vector<Photon>& photons,
                      const std::vector<TreePoint>& ordered, const TriangleMesh& mesh)
{
    std::vector<std::uint32_t> place(photons.size());
    for (std::size_t i = 0; i < ordered.size(); ++i)
        place[ordered[i].photon] = static_cast<std::uint32_t>(i);
    const std::size_t keys = maps.sides() * mesh.face_count();
    Groups groups = group_by_key(photons, keys, [&](const Photon& photon) {
        return maps.index_by_side(photon.face, photon.side);
    });
    maps.local_of_face.assign(keys, kNone);
    std::vector<std::size_t> key_of_local;
    for (std::size_t key = 0; key < keys; ++key) {
        const std::size_t count = groups.of(key).size();
        if (count == 0 || count < maps.options.local_min)
            continue;
        maps.local_of_face[key] = static_cast<std::uint32_t>(key_of_local.size());
        key_of_local.push_back(key);
    }
    maps.locals.resize(key_of_local.size());
    tbb::parallel_for(std::size_t{0}, maps.locals.size(), [&](std::size_t i) {
        const std::span<TreePoint> points = groups.of(key_of_local[i]);
        LocalMap& local = maps.locals[i];
        local.tree = build_wide_tree(points);
        for (const TreePoint& point : points)
            local.photons.push_back(place[point.photon]);
        local.filter_radius =
            filter_radius(face_area(mesh, static_cast<FaceId>(key_of_local[i] / maps.sides())),
                          maps.options.neighbours, points.size());
    });
}

} // namespace

float filter_radius(double area, std::uint32_t neighbours, std::uint64_t photons)
{
    if (photons == 0)
        return std::numeric_limits<float>::infinity();
    return static_cast<float>(
        std::sqrt(area * neighbours / (std::numbers::pi * static_cast<double>(photons))));
}

std::size_t PhotonMaps::filled_maps() const
{
    std::size_t filled = 0;
    for (std::size_t m = 0; m + 1 < first_photon.size(); ++m)
        filled += first_photon[m + 1] > first_photon[m] ? 1 : 0;
    return filled;
}

PhotonMaps build_photon_maps(const std::vector<Photon>& photons, const TriangleMesh& mesh,
                             const Partition& partition, const MapOptions& options)
{
    if (photons.size() > std::numeric_limits<std::uint32_t>::max())
        throw InputError("a pass stores " + std::to_string(photons.size()) +
                         " photons of one kind, more than 4294967295; ask for fewer --photons");
    PhotonMaps maps;
    maps.options = options;
    const bool one_map = options.mode == MapMode::global;
    maps.map_area = areas_of_maps(maps, mesh, partition,
                                  one_map ? 1 : std::size_t{maps.sides()} * partition.map_count);
    const Groups groups = build_trees(maps, photons, partition);
    if (options.mode == MapMode::thesis)
        build_local_maps(maps, photons, groups.points, mesh);
    if (options.mode == MapMode::hierarchical)
        build_tiers(maps, mesh, partition);
    return maps;
}

} // namespace hipmap
