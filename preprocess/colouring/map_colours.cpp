#include "preprocess/colouring/map_colours.h"

#include <algorithm>
#include <numeric>
#include <span>

namespace hipmap {

namespace {

using RegionId = std::uint32_t;

/// Which regions, maps or groups, meet at an edge: neighbours of region r are ids[first[r]] to
/// ids[first[r + 1]].
struct Neighbours {
    std::vector<RegionId> ids;
    std::vector<std::size_t> first;

    std::span<const RegionId> of(RegionId region) const
    {
        return std::span(ids).subspan(first[region], first[region + 1] - first[region]);
    }
};

Neighbours find_neighbours(const std::vector<std::uint32_t>& opposite,
                           const std::vector<RegionId>& region_of_face, std::uint32_t regions)
{
    std::vector<std::pair<RegionId, RegionId>> pairs;
    for (std::uint32_t edge = 0; edge < opposite.size(); ++edge) {
        if (opposite[edge] == kNone)
            continue;
        const RegionId a = region_of_face[edge / 3];
        const RegionId b = region_of_face[opposite[edge] / 3];
        if (a != b && a != kNone && b != kNone)
            pairs.emplace_back(a, b);
    }
    std::ranges::sort(pairs);
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());

    Neighbours out;
    out.first.assign(regions + std::size_t{1}, 0);
    for (const auto& [region, neighbour] : pairs) {
        ++out.first[region + std::size_t{1}];
        out.ids.push_back(neighbour);
    }
    std::partial_sum(out.first.begin(), out.first.end(), out.first.begin());
    return out;
}

/// The first number from the region's own on that no coloured neighbour has.
std::uint32_t free_colour(RegionId region, std::span<const RegionId> neighbours,
                          const std::vector<std::uint32_t>& colour_of_region)
{
    std::vector<bool> taken(kDistinctColours + neighbours.size() + 1);
    for (const RegionId neighbour : neighbours)
        if (colour_of_region[neighbour] < taken.size())
            taken[colour_of_region[neighbour]] = true;
    for (std::uint32_t step = 0; step < kDistinctColours; ++step)
        if (const std::uint32_t colour = (region + step) % kDistinctColours; !taken[colour])
            return colour;
    std::uint32_t colour = kDistinctColours;
    while (taken[colour])
        ++colour;
    return colour;
}

std::vector<Rgb> region_colours(const Neighbours& neighbours, std::uint32_t regions)
{
    std::vector<RegionId> order(regions);
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::stable_sort(order, std::greater<>{},
                             [&](RegionId region) { return neighbours.of(region).size(); });

    std::vector<std::uint32_t> colour_of_region(regions, kNone);
    std::vector<Rgb> colours(regions);
    for (const RegionId region : order) {
        colour_of_region[region] = free_colour(region, neighbours.of(region), colour_of_region);
        colours[region] = palette_colour(colour_of_region[region]);
    }
    return colours;
}

} // namespace

std::vector<Rgb> map_colours(const Partition& p)
{
    return region_colours(find_neighbours(p.opposite, p.map_of_face, p.map_count), p.map_count);
}

std::vector<Rgb> group_colours(const Partition& p)
{
    return region_colours(find_neighbours(p.opposite, p.group_of_face, p.group_count),
                          p.group_count);
}

} // namespace hipmap
