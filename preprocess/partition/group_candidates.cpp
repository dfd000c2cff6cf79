#include "preprocess/partition/group_candidates.h"

#include "preprocess/partition/group_clearance.h"
#include "preprocess/partition/local_candidates.h"
#include "preprocess/partition/patches.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hipmap {
namespace {

/// What a clearance may fall short by, of the radius of a disc as large as the patch.
constexpr double kSlack = 1.0 / 16;

float rounded_down(double value)
{
    const auto nearest = static_cast<float>(value);
    return nearest > value ? std::nextafter(nearest, 0.0f) : nearest;
}

} // namespace

GroupCandidates find_group_candidates(const TriangleMesh& mesh, const SharedMaps& maps,
                                      const FaceTree& tree, double position_error)
{
    const std::vector<MapId> map_of_node = tree.labels_of_nodes(maps.map_of_face);
    const Patches patches = find_patches(mesh, maps, tree, map_of_node);
    const PatchSurroundings around{mesh,
                                   tree,
                                   maps.map_of_face,
                                   patches.patch_of_face,
                                   map_of_node,
                                   tree.labels_of_nodes(patches.patch_of_face)};
    GroupCandidates out;
    out.group_of_face.assign(mesh.face_count(), kNone);
    out.group_radius.assign(mesh.face_count(), 0.0f);
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
        if (!(best - position_error > widest_filter_radius(area)))
            return;
        for (const auto& [face, distance] : found) {
            out.group_of_face[face] = patches.patch_of_face[face];
            out.group_radius[face] = rounded_down(std::max(0.0, distance - position_error));
        }
    });
    out.count = number_by_first(out.group_of_face);
    return out;
}

} // namespace hipmap
