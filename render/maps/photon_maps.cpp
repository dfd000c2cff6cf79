#include "render/maps/photon_maps.h"

#include "common/input_error.h"
#include "render/maps/photon_groups.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

namespace hipmap {

namespace {

/// From so many sides of maps on, those that hold no photon take no memory.
constexpr std::size_t kManyKeys = std::size_t{1} << 20;

/// [sides of maps that hold photons] their keys, ascending.
template <typename KeyOf>
std::vector<std::uint64_t> keys_of(const std::vector<Photon>& photons, const KeyOf& key_of)
{
    std::vector<std::uint64_t> keys(photons.size());
    tbb::parallel_for(std::size_t{0}, photons.size(),
                      [&](std::size_t i) { keys[i] = key_of(photons[i]); });
    tbb::parallel_sort(keys.begin(), keys.end());
    keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
    keys.shrink_to_fit();
    return keys;
}

/// Builds the maps of all groups that have photons.
void build_maps(PhotonGroups groups, const std::vector<Photon>& photons, PhotonMaps& maps)
{
    std::vector<std::size_t> group_of_map;
    for (std::size_t group = 0; group + 1 < groups.first.size(); ++group)
        if (!groups.of(group).empty())
            group_of_map.push_back(group);
    maps.maps.resize(group_of_map.size());
    tbb::parallel_for(std::size_t{0}, maps.maps.size(), [&](std::size_t m) {
        const std::span<TreePoint> points = groups.of(group_of_map[m]);
        maps.maps[m] = pack_photons(build_wide_tree(points), points, photons,
                                    {maps.power_scale, maps.options.directions});
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

std::size_t PhotonMaps::bytes() const
{
    std::size_t sum = map_of.size() * sizeof(std::uint32_t) + held.size() * sizeof(std::uint64_t);
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

PhotonMap pack_photons(WideTree tree, std::span<const TreePoint> points,
                       const std::vector<Photon>& photons, const PhotonPacking& packing)
{
    PhotonMap map;
    map.tree = std::move(tree);
    map.powers = build_powers(map.tree, points, photons, packing.scale);
    map.faces.resize(points.size());
    map.directions.resize(packing.directions ? points.size() : 0);
    tbb::parallel_for(std::size_t{0}, points.size(), [&](std::size_t slot) {
        const Photon& photon = photons[points[slot].photon];
        map.faces[slot] = photon.face;
        if (packing.directions)
            map.directions[slot] = pack_direction(photon.direction);
    });
    map.side = photons[points[0].photon].side;
    return map;
}

void check_photon_count(const std::vector<Photon>& photons)
{
    if (photons.size() > std::numeric_limits<std::uint32_t>::max())
        throw InputError("a pass stores " + std::to_string(photons.size()) +
                         " photons of one kind, more than 4294967295; use fewer --photons");
}

PhotonMaps build_photon_maps(const std::vector<Photon>& photons, const Partition& partition,
                             const MapOptions& options)
{
    check_photon_count(photons);
    PhotonMaps maps;
    maps.options = options;
    maps.size = photons.size();
    if (photons.empty())
        return maps;
    maps.power_scale = power_scale(photons);
    const auto key_of = [&](const Photon& photon) {
        return PhotonMaps::map_index(partition.map_of(photon.face), photon.side);
    };
    const std::size_t keys = std::size_t{2} * partition.all_map_count();
    if (keys > kManyKeys && keys / 4 > photons.size()) {
        maps.held = keys_of(photons, key_of);
        const auto place = [&](const Photon& photon) {
            return static_cast<std::size_t>(std::ranges::lower_bound(maps.held, key_of(photon)) -
                                            maps.held.begin());
        };
        build_maps(group_photons(photons, maps.held.size(), place), photons, maps);
        return maps;
    }
    PhotonGroups groups = group_photons(photons, keys, key_of);
    maps.map_of.assign(keys, kNone);
    std::uint32_t next = 0;
    for (std::size_t key = 0; key < keys; ++key)
        if (!groups.of(key).empty())
            maps.map_of[key] = next++;
    build_maps(std::move(groups), photons, maps);
    return maps;
}

} // namespace hipmap
