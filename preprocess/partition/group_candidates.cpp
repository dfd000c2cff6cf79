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

double area_of(const TriangleMesh& mesh, std::span<const FaceId> faces)
{
    double area = 0;
    for (const FaceId face : faces)
        area += face_area(mesh, face);
    return area;
}

float rounded_down(double value)
{
    const auto nearest = static_cast<float>(value);
    return nearest > value ? std::nextafter(nearest, 0.0f) : nearest;
}

} // namespace

GroupCandidates find_group_candidates(const TriangleMesh& mesh, const SharedMaps& maps,
                                      const FaceTree& tree, double position_error)
{
    const Patches patches = find_patches(mesh, maps);
    const SortedFaces faces_of_patches =
        sort_faces(tree.faces(tree.root()), patches.patch_of_face, patches.count);
    const PatchSurroundings around{mesh,
                                   tree,
                                   maps.map_of_face,
                                   patches.patch_of_face,
                                   tree.labels_of_nodes(maps.map_of_face),
                                   tree.labels_of_nodes(patches.patch_of_face)};
    GroupCandidates out;
    out.group_of_face.assign(mesh.face_count(), kNone);
    out.group_radius.assign(mesh.face_count(), 0.0f);
    tbb::parallel_for(std::uint32_t{0}, patches.count, [&](std::uint32_t patch) {
        const std::span<const FaceId> faces = faces_of_patches.of(patch);
        const double area = area_of(mesh, faces);
        const double slack = kSlack * std::sqrt(area / std::numbers::pi);
        const std::vector<double> clearances = clearances_of_patch(around, faces, slack);
        const double best = *std::ranges::max_element(clearances) - position_error;
        if (!(best > widest_filter_radius(area)))
            return;
        for (std::size_t i = 0; i < faces.size(); ++i) {
            out.group_of_face[faces[i]] = patch;
            out.group_radius[faces[i]] =
                rounded_down(std::max(0.0, clearances[i] - position_error));
        }
    });
    out.count = number_by_first(out.group_of_face);
    return out;
}

} // namespace hipmap
