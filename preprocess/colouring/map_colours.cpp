#include "preprocess/colouring/map_colours.h"

#include <algorithm>
#include <numeric>
#include <span>

namespace hipmap {

namespace {

/// Which maps meet at an edge: neighbours of map m are ids[first[m]] to ids[first[m + 1]].
struct Neighbours {
    std::vector<MapId> ids;
    std::vector<std::size_t> first;

    std::span<const MapId> of(MapId map) const
    {
        return std::span(ids).subspan(first[map], first[map + 1] - first[map]);
    }
};

Neighbours find_neighbours(const Partition& partition)
{
    std::vector<std::pair<MapId, MapId>> pairs;
    for (std::uint32_t edge = 0; edge < partition.opposite.size(); ++edge) {
        if (partition.opposite[edge] == kNone)
            continue;
        const MapId a = partition.map_of_face[edge / 3];
        const MapId b = partition.map_of_face[partition.opposite[edge] / 3];
        if (a != b)
            pairs.emplace_back(a, b);
    }
    std::ranges::sort(pairs);
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());

    Neighbours out;
    out.first.assign(partition.map_count + std::size_t{1}, 0);
    for (const auto& [map, neighbour] : pairs) {
        ++out.first[map + std::size_t{1}];
        out.ids.push_back(neighbour);
    }
    std::partial_sum(out.first.begin(), out.first.end(), out.first.begin());
    return out;
}

/// The first number from the map's own on that no coloured neighbour has.
std::uint32_t free_colour(MapId map, std::span<const MapId> neighbours,
                          const std::vector<std::uint32_t>& colour_of_map)
{
    std::vector<bool> taken(kDistinctColours + neighbours.size() + 1);
    for (const MapId neighbour : neighbours)
        if (colour_of_map[neighbour] < taken.size())
            taken[colour_of_map[neighbour]] = true;
    for (std::uint32_t step = 0; step < kDistinctColours; ++step)
        if (const std::uint32_t colour = (map + step) % kDistinctColours; !taken[colour])
            return colour;
    std::uint32_t colour = kDistinctColours;
    while (taken[colour])
        ++colour;
    return colour;
}

} // namespace

std::vector<Rgb> map_colours(const Partition& partition)
{
    const Neighbours neighbours = find_neighbours(partition);
    std::vector<MapId> order(partition.map_count);
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::stable_sort(order, std::greater<>{},
                             [&](MapId map) { return neighbours.of(map).size(); });

    std::vector<std::uint32_t> colour_of_map(partition.map_count, kNone);
    std::vector<Rgb> colours(partition.map_count);
    for (const MapId map : order) {
        colour_of_map[map] = free_colour(map, neighbours.of(map), colour_of_map);
        colours[map] = palette_colour(colour_of_map[map]);
    }
    return colours;
}

} // namespace hipmap
