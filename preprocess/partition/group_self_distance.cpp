#include "preprocess/partition/group_self_distance.h"

#include "common/partition/limiting_radius.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace hipmap {
namespace {

/// Nodes that the searches of one patch may go through, besides so many for each of its faces:
/// enough by far.
constexpr std::int64_t kMostNodes = 4096;
constexpr std::int64_t kMostNodesPerFace = 64;

/// Clumps of fewer faces are looked at with the next ones.
constexpr std::size_t kFewFaces = 8;

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
    const std::uint32_t patch = around.patch_of_face[from];
    std::array<Visit, FaceTree::kMostDepth + 2> stack;
    std::size_t depth = 0;
    Outside nearest = known;
    stack[depth++] = {tree.root(), 0.0};
    while (depth > 0 && --budget >= 0) {
        const auto [range, distance2] = stack[--depth];
        if (distance2 >= nearest.distance2 || around.patch_of_node[range.node] == patch)
            continue;
        if (tree.is_leaf(range)) {
            for (const FaceId face : tree.faces(range)) {
                if (around.patch_of_face[face] == patch ||
                    box_distance2(point, face_box(around.mesh, face)) >= nearest.distance2)
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

/// No face of the map outside the patch comes into it.
struct Ball {
    glm::dvec3 centre{0.0};
    double radius = -std::numeric_limits<double>::infinity();

    /// How far a point is from what is outside, at least.
    double depth(const glm::dvec3& point) const { return radius - glm::distance(centre, point); }
};

/// Finds distances in a patch.
class PatchDistances {
  public:
    /// budget: the nodes that searches may go through.
    PatchDistances(const PatchSurroundings& around, double slack, std::int64_t budget)
        : around_(around), slack_(slack), budget_(budget)
    {
    }

    /// Appends those of some faces, not none, that had better be near each other and the last ones.
    void append(std::span<const FaceId> faces, std::vector<FaceDistance>& out);

    /// Whether it took too long, and no distance is to be trusted.
    bool given_up() const { return budget_ < 0; }

  private:
    /// Least distance of a point that the first two balls say.
    double least(const glm::dvec3& point) const
    {
        return std::max(balls_[0].depth(point), balls_[1].depth(point));
    }
    /// Bounds the distance of a point by what was found last and by the two balls in which it is
    /// deepest, which become the first; returns how far the bounds are apart.
    double bound(const glm::dvec3& point);
    void search(FaceId face, const glm::dvec3& point);

    const PatchSurroundings& around_;
    double slack_;
    std::int64_t budget_;
    Outside found_;             ///< and its distance from the last point looked at
    std::array<Ball, 8> balls_; ///< of the last searches
    std::vector<glm::dvec3> centres_;
};

double PatchDistances::bound(const glm::dvec3& point)
{
    std::ranges::partial_sort(balls_, balls_.begin() + 2, std::ranges::greater{},
                              [&](const Ball& ball) { return ball.depth(point); });
    if (found_.face != kNone)
        found_.distance2 = face_distance2(around_.mesh, found_.face, point);
    return std::sqrt(found_.distance2) - least(point);
}

void PatchDistances::search(FaceId face, const glm::dvec3& point)
{
    found_ = nearest_outside(around_, face, point, found_, budget_);
    std::shift_right(balls_.begin(), balls_.end(), 1);
    balls_[0] = {point, std::sqrt(found_.distance2)};
}

void PatchDistances::append(std::span<const FaceId> faces, std::vector<FaceDistance>& out)
{
    centres_.clear();
    glm::dvec3 middle(0.0);
    for (const FaceId face : faces) {
        centres_.push_back(face_centre(around_.mesh, face));
        middle += centres_.back() / static_cast<double>(faces.size());
    }
    if (bound(middle) > 0.5 * slack_)
        search(faces[0], middle);
    const double most = std::sqrt(found_.distance2);
    for (std::size_t i = 0; i < faces.size(); ++i) {
        const glm::dvec3& centre = centres_[i];
        if (most + glm::distance(centre, middle) - least(centre) > slack_ && bound(centre) > slack_)
            search(faces[i], centre);
        out.push_back({faces[i], std::max(0.0, least(centre))});
    }
}

} // namespace

std::vector<FaceDistance> distances_of_patch(const PatchSurroundings& around,
                                             std::span<const Clump> clumps, double slack)
{
    std::int64_t budget = kMostNodes;
    for (const Clump& clump : clumps)
        budget += kMostNodesPerFace * std::int64_t{clump.end - clump.begin};
    PatchDistances distances(around, slack, budget);
    std::vector<FaceDistance> out;
    std::vector<FaceId> together;
    for (const Clump& clump : clumps) {
        const std::span<const FaceId> faces = around.tree.faces({0, clump.begin, clump.end});
        together.insert(together.end(), faces.begin(), faces.end());
        if (together.size() < kFewFaces && &clump != &clumps.back())
            continue;
        distances.append(together, out);
        if (distances.given_up())
            return {};
        together.clear();
    }
    return out;
}

} // namespace hipmap
