#include "render/maps/photon_maps.h"

#include "common/input_error.h"
#include "render/maps/photon_groups.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>
#include <xxhash.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <new>
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

/// A photon without the bytes between its members, which have no value.
struct PhotonRecord {
    glm::vec3 position, power, direction;
    std::uint32_t face, side;
};
static_assert(sizeof(PhotonRecord) == 11 * sizeof(float));

/// The hash of what the map of some photons holds.
MapContent content_of(std::span<const TreePoint> points, const std::vector<Photon>& photons,
                      const PhotonPacking& packing)
{
    struct Free {
        void operator()(XXH3_state_t* state) const { XXH3_freeState(state); }
    };
    const std::unique_ptr<XXH3_state_t, Free> state(XXH3_createState());
    if (!state)
        throw std::bad_alloc();
    const auto add = [&](const void* data, std::size_t bytes) {
        XXH3_128bits_update(state.get(), data, bytes);
    };
    XXH3_128bits_reset(state.get());
    add(&packing.scale.unit, sizeof(packing.scale.unit));
    const std::uint64_t head[] = {points.size(), packing.directions ? 1u : 0u};
    add(head, sizeof(head));
    std::array<PhotonRecord, 64> records;
    for (std::size_t begin = 0; begin < points.size(); begin += records.size()) {
        const std::size_t count = std::min(records.size(), points.size() - begin);
        for (std::size_t i = 0; i < count; ++i) {
            const Photon& photon = photons[points[begin + i].photon];
            records[i] = {photon.position, photon.power, photon.direction, photon.face,
                          photon.side};
        }
        add(records.data(), count * sizeof(PhotonRecord));
    }
    const XXH128_hash_t hash = XXH3_128bits_digest(state.get());
    return {hash.low64, hash.high64};
}

/// Where each content is among some maps.
std::map<MapContent, std::size_t> places_of(const PhotonMaps* maps)
{
    std::map<MapContent, std::size_t> places;
    for (std::size_t m = 0; maps != nullptr && m < maps->contents.size(); ++m)
        places[maps->contents[m]] = m;
    return places;
}

/// Builds the maps of all groups that have photons, or moves them from `previous`.
void build_maps(PhotonGroups groups, const std::vector<Photon>& photons, PhotonMaps& maps,
                PhotonMaps* previous)
{
    std::vector<std::size_t> group_of_map;
    for (std::size_t group = 0; group + 1 < groups.first.size(); ++group)
        if (!groups.of(group).empty())
            group_of_map.push_back(group);
    maps.maps.resize(group_of_map.size());
    maps.contents.resize(previous != nullptr ? maps.maps.size() : 0);
    const PhotonPacking packing{maps.power_scale, maps.options.directions};
    const std::map<MapContent, std::size_t> places = places_of(previous);
    std::atomic<std::uint64_t> taken_over{0};
    tbb::parallel_for(std::size_t{0}, maps.maps.size(), [&](std::size_t m) {
        const std::span<TreePoint> points = groups.of(group_of_map[m]);
        if (previous != nullptr) {
            maps.contents[m] = content_of(points, photons, packing);
            // Faces are part of the content, so no two of the maps find the same one.
            if (const auto found = places.find(maps.contents[m]); found != places.end()) {
                maps.maps[m] = std::move(previous->maps[found->second]);
                ++taken_over;
                return;
            }
        }
        maps.maps[m] = pack_photons(build_wide_tree(points), points, photons, packing);
    });
    maps.taken_over = taken_over;
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
    std::size_t sum = map_of.size() * sizeof(std::uint32_t) + held.size() * sizeof(std::uint64_t) +
                      contents.size() * sizeof(MapContent);
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
                             const MapOptions& options, PhotonMaps* previous)
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
        build_maps(group_photons(photons, maps.held.size(), place), photons, maps, previous);
        return maps;
    }
    PhotonGroups groups = group_photons(photons, keys, key_of);
    maps.map_of.assign(keys, kNone);
    std::uint32_t next = 0;
    for (std::size_t key = 0; key < keys; ++key)
        if (!groups.of(key).empty())
            maps.map_of[key] = next++;
    build_maps(std::move(groups), photons, maps, previous);
    return maps;
}

} // namespace hipmap
