#include "preprocess/partition/group_candidates.h"

#include "preprocess/partition/group_self_distance.h"
#include "preprocess/partition/local_candidates.h"
#include "preprocess/partition/patches.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hipmap {
namespace {

/// What a self-distance may fall short by, of the radius of a disc as large as the patch.
constexpr double kSlack = 1.0 / 16;

float rounded_down(double value)
{
    const auto nearest = static_cast<float>(value);
    return nearest > value ? std::nextafter(nearest, 0.0f) : nearest;
}

} // namespace

void find_group_candidates(const MapTree& map, double position_error, GroupCandidates& out)
{
    const Patches patches = find_patches(map, out.group_of_face);
    const PatchSurroundings around{map.mesh, map.tree, out.group_of_face,
                                   map.tree.labels_of_nodes(out.group_of_face)};
    std::vector<std::uint8_t> kept(patches.first.size(), 0);
    tbb::parallel_for(std::size_t{1}, patches.first.size(), [&](std::size_t i) {
        const std::span<const Clump> clumps = patches.of(i - 1);
        double area = 0;
        for (const Clump& clump : clumps)
            area += clump.area;
        const double slack = kSlack * std::sqrt(area / std::numbers::pi);
        const std::vector<FaceDistance> found = distances_of_patch(around, clumps, slack);
        if (found.empty())
            return;
        const double best = std::ranges::max(found, {}, &FaceDistance::distance).distance;
        kept[i] = best - position_error > widest_filter_radius(area);
        for (const auto& [face, distance] : found)
            if (kept[i] != 0)
                out.group_radius[face] = rounded_down(std::max(0.0, distance - position_error));
    });
    tbb::parallel_for(std::size_t{1}, patches.first.size(), [&](std::size_t i) {
        if (kept[i] != 0)
            return;
        for (const Clump& clump : patches.of(i - 1))
            for (const FaceId face : map.tree.faces({0, clump.begin, clump.end}))
                out.group_of_face[face] = kNone;
    });
}

} // namespace hipmap
