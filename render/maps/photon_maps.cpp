#include "render/maps/photon_maps.h"

#include <tbb/parallel_for.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace hipmap {

namespace {

/// Stable counting sort of photon indices by key; keys[i] < key_count.
std::vector<std::uint64_t> group_by_key(const std::vector<Photon>& photons,
                                        const std::vector<std::uint32_t>& keys,
                                        std::size_t key_count, std::vector<TreePoint>& grouped)
{
    std::vector<std::uint64_t> first(key_count + 1, 0);
    for (const std::uint32_t key : keys)
        ++first[key + 1];
    for (std::size_t k = 0; k < key_count; ++k)
        first[k + 1] += first[k];
    std::vector<std::uint64_t> next(first.begin(), first.end() - 1);
    grouped.resize(photons.size());
    for (std::size_t i = 0; i < photons.size(); ++i)
        grouped[next[keys[i]]++] = {photons[i].position, static_cast<std::uint32_t>(i)};
    return first;
}

void split_into_maps(PhotonMaps& maps, const TriangleMesh& mesh, const Partition& partition)
{
    const bool one_map = maps.options.mode == MapMode::global;
    const std::size_t map_count = one_map ? 1 : 2 * std::size_t{partition.map_count};
    std::vector<std::uint32_t> keys;
    keys.reserve(maps.photons.size());
    for (const Photon& photon : maps.photons)
        keys.push_back(static_cast<std::uint32_t>(
            maps.map_index(partition.map_of_face[photon.face], photon.side)));
    maps.first_point = group_by_key(maps.photons, keys, map_count, maps.points);

    std::vector<double> area(map_count, 0.0);
    for (FaceId face = 0; face < mesh.face_count(); ++face) {
        if (partition.map_of_face[face] == kNone)
            continue;
        const std::size_t map = maps.map_index(partition.map_of_face[face], 0);
        area[map] += face_area(mesh, face);
        if (!one_map)
            area[map + 1] = area[map];
    }
    maps.map_area.assign(area.begin(), area.end());
}

void order_all_trees(PhotonMaps& maps)
{
    maps.axes.resize(maps.points.size());
    tbb::parallel_for(std::size_t{0}, maps.map_area.size(), [&](std::size_t m) {
        const std::size_t begin = maps.first_point[m], count = maps.first_point[m + 1] - begin;
        order_tree({maps.points.data() + begin, count}, {maps.axes.data() + begin, count});
    });
}

/// Algorithm 3 of the thesis: every face keeps references to its photons; then faces with fewer
/// than local_min lose their map, the others get their filter radius.
void build_local_maps(PhotonMaps& maps, const TriangleMesh& mesh)
{
    std::vector<std::uint32_t> keys;
    keys.reserve(maps.photons.size());
    for (const Photon& photon : maps.photons)
        keys.push_back(2 * photon.face + photon.side);
    const std::vector<std::uint64_t> first =
        group_by_key(maps.photons, keys, 2 * mesh.face_count(), maps.local_points);
    maps.local_axes.resize(maps.local_points.size());
    maps.local_of_face.assign(2 * mesh.face_count(), kNone);
    for (std::size_t key = 0; key + 1 < first.size(); ++key) {
        const std::size_t begin = first[key], count = first[key + 1] - begin;
        if (count == 0 || count < maps.options.local_min)
            continue;
        LocalMap local;
        local.tree.points = {maps.local_points.data() + begin, count};
        local.tree.axes = {maps.local_axes.data() + begin, count};
        local.filter_radius = filter_radius(face_area(mesh, static_cast<FaceId>(key / 2)),
                                            maps.options.neighbours, count);
        maps.local_of_face[key] = static_cast<std::uint32_t>(maps.locals.size());
        maps.locals.push_back(local);
    }
    tbb::parallel_for(std::size_t{0}, maps.locals.size(), [&](std::size_t i) {
        const PhotonTree& tree = maps.locals[i].tree;
        const std::size_t begin =
            static_cast<std::size_t>(tree.points.data() - maps.local_points.data());
        order_tree({maps.local_points.data() + begin, tree.points.size()},
                   {maps.local_axes.data() + begin, tree.points.size()});
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
    for (std::size_t m = 0; m + 1 < first_point.size(); ++m)
        filled += first_point[m + 1] > first_point[m] ? 1 : 0;
    return filled;
}

PhotonMaps build_photon_maps(std::vector<Photon> photons, const TriangleMesh& mesh,
                             const Partition& partition, const MapOptions& options)
{
    PhotonMaps maps;
    maps.options = options;
    maps.photons = std::move(photons);
    split_into_maps(maps, mesh, partition);
    order_all_trees(maps);
    if (options.mode == MapMode::thesis)
        build_local_maps(maps, mesh);
    return maps;
}

} // namespace hipmap
