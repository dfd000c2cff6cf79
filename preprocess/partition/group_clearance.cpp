#include "preprocess/partition/group_clearance.h"

#include "common/partition/limiting_radius.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace hipmap {
namespace {

/// Nodes that the searches of one patch may go through, besides so many for each of its faces:
/// enough by far unless other maps lie all through the patch.
constexpr std::int64_t kMostNodes = 4096;
constexpr std::int64_t kMostNodesPerFace = 64;

double box_distance2(const glm::dvec3& point, const Bounds<glm::vec3>& box)
{
    const glm::dvec3 off = glm::max(
        glm::max(glm::dvec3(box.low) - point, point - glm::dvec3(box.high)), glm::dvec3(0.0));
    return glm::dot(off, off);
}

double segment_distance2(const glm::dvec3& point, const glm::dvec3& a, const glm::dvec3& b)
{
    const glm::dvec3 along = b - a;
    const double length2 = glm::dot(along, along);
    const double t = length2 > 0 ? std::clamp(glm::dot(point - a, along) / length2, 0.0, 1.0) : 0.0;
    const glm::dvec3 off = point - a - t * along;
    return glm::dot(off, off);
}

/// The outline counts even where the foot of the point is inside: all of a sliver, whose normal may
/// be mostly rounding, is near its outline.
double face_distance2(const TriangleMesh& mesh, FaceId face, const glm::dvec3& point)
{
    const glm::dvec3 normal = scaled_normal(mesh, face);
    bool inside = true;
    double least = std::numeric_limits<double>::infinity();
    for (int c = 0; c < 3; ++c) {
        const glm::dvec3 a(mesh.positions[mesh.corners[face][c]]);
        const glm::dvec3 b(mesh.positions[mesh.corners[face][(c + 1) % 3]]);
        least = std::min(least, segment_distance2(point, a, b));
        inside &= glm::dot(glm::cross(normal, b - a), point - a) > 0;
    }
    if (!inside)
        return least;
    const double height =
        glm::dot(point - glm::dvec3(mesh.positions[mesh.corners[face].x]), normal);
    return std::min(least, height * height / glm::dot(normal, normal));
}

/// A face of the map outside the patch.
struct Outside {
    FaceId face = kNone;
    double distance2 = std::numeric_limits<double>::infinity();
};

/// The face outside the patch of `from` that is nearest to a point; `known` unless one is nearer.
/// Takes the nodes it goes through off `budget`, and is not to be trusted if that falls below 0.
Outside nearest_outside(const PatchSurroundings& around, FaceId from, const glm::dvec3& point,
                        const Outside& known, std::int64_t& budget)
{
    struct Visit {
        FaceTree::Range range;
        double distance2;
    };
    const FaceTree& tree = around.tree;
    const MapId map = around.map_of_face[from];
    const std::uint32_t patch = around.patch_of_face[from];
    std::array<Visit, FaceTree::kMostDepth + 2> stack;
    std::size_t depth = 0;
    Outside nearest = known;
    stack[depth++] = {tree.root(), 0.0};
    while (depth > 0 && --budget >= 0) {
        const auto [range, distance2] = stack[--depth];
        const MapId map_here = around.map_of_node[range.node];
        if (distance2 >= nearest.distance2 || (map_here != map && map_here != kNone) ||
            around.patch_of_node[range.node] == patch)
            continue;
        if (tree.is_leaf(range)) {
            for (const FaceId face : tree.faces(range)) {
                if (around.map_of_face[face] != map || around.patch_of_face[face] == patch)
                    continue;
                if (const double d2 = face_distance2(around.mesh, face, point);
                    d2 < nearest.distance2)
                    nearest = {face, d2};
            }
            continue;
        }
        const auto [left, right] = tree.children(range);
        Visit nearer{left, box_distance2(point, tree.box(left))};
        Visit farther{right, box_distance2(point, tree.box(right))};
        if (farther.distance2 < nearer.distance2)
            std::swap(nearer, farther);
        stack[depth++] = farther;
        stack[depth++] = nearer;
    }
    return nearest;
}

} // namespace

std::vector<double> clearances_of_patch(const PatchSurroundings& around,
                                        std::span<const FaceId> faces, double slack)
{
    std::vector<double> out;
    out.reserve(faces.size());
    std::int64_t budget = kMostNodes + kMostNodesPerFace * static_cast<std::int64_t>(faces.size());
    glm::dvec3 searched_at = face_centre(around.mesh, faces[0]);
    Outside found = nearest_outside(around, faces[0], searched_at, {}, budget);
    double distance = std::sqrt(found.distance2);
    for (const FaceId face : faces) {
        if (budget < 0)
            break;
        const glm::dvec3 centre = face_centre(around.mesh, face);
        // The last search bounds the distance from here from below, the face it found from above.
        double least = distance - glm::distance(centre, searched_at);
        const Outside known{found.face, face_distance2(around.mesh, found.face, centre)};
        if (std::sqrt(known.distance2) - least > slack) {
            found = nearest_outside(around, face, centre, known, budget);
            searched_at = centre;
            least = distance = std::sqrt(found.distance2);
        }
        out.push_back(std::max(0.0, least));
    }
    if (budget < 0)
        out.assign(faces.size(), 0.0);
    return out;
}

} // namespace hipmap
