#include "preprocess/partition/face_surroundings.h"

#include "preprocess/partition/polygon_distance.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace hipmap {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A face whose self-distance takes more faces than this is given up.
constexpr int kMostFaces = 4096;

std::array<glm::dvec3, 3> corners_of(const TriangleMesh& mesh, FaceId face)
{
    const glm::uvec3 c = mesh.corners[face];
    return {glm::dvec3(mesh.positions[c.x]), glm::dvec3(mesh.positions[c.y]),
            glm::dvec3(mesh.positions[c.z])};
}

/// Square of the distance between two boxes, or a little less.
float box_distance2(const Bounds<glm::vec3>& a, const Bounds<glm::vec3>& b)
{
    constexpr float kRounding = 1 - 1e-6f;
    const glm::vec3 off = glm::max(glm::max(a.low - b.high, b.low - a.high), glm::vec3(0.0f));
    return kRounding * glm::dot(off, off);
}

} // namespace

FaceSurroundings::FaceSurroundings(const MapTree& map, FaceId face, double error)
    : map_(map), face_(face), error_(error), corners_(corners_of(map.mesh, face))
{
    const glm::dvec3 normal = scaled_normal(map.mesh, face);
    for (int c = 0; c < 3; ++c)
        planes_[c] = edge_plane(map.mesh, face, c, normal);
}

double FaceSurroundings::largest_height(unsigned edges) const
{
    if (edges == 0)
        return kInfinity;
    std::array<double, 3> highest; // over each plane: the corner across
    for (std::size_t c = 0; c < 3; ++c)
        highest[c] = planes_[c].height(corners_[(c + 2) % 3]);
    if (std::has_single_bit(edges))
        return highest[static_cast<std::size_t>(std::countr_zero(edges))];
    if (edges == 7) {
        const double first = glm::length(corners_[1] - corners_[0]);
        return first * highest[0] /
               (first + glm::length(corners_[2] - corners_[1]) +
                glm::length(corners_[0] - corners_[2]));
    }
    // On the third edge the height over one plane falls from its highest to 0 as the other rises.
    const auto open = static_cast<std::size_t>(std::countr_zero(~edges & 7u));
    const double h1 = highest[(open + 1) % 3];
    const double h2 = highest[(open + 2) % 3];
    return h1 * h2 / (h1 + h2);
}

bool FaceSurroundings::behind(unsigned edges, const Bounds<glm::vec3>& box) const
{
    for (int c = 0; c < 3; ++c) {
        if (!(edges >> c & 1))
            continue;
        const glm::dvec3& inward = planes_[c].inward;
        glm::dvec3 foremost;
        for (int axis = 0; axis < 3; ++axis)
            foremost[axis] = inward[axis] > 0 ? box.high[axis] : box.low[axis];
        if (planes_[c].height(foremost) <= error_)
            return true;
    }
    return false;
}

double FaceSurroundings::distance_of(unsigned edges, FaceId other) const
{
    const std::array<glm::dvec3, 3> corners = corners_of(map_.mesh, other);
    unsigned cut = 0; // by which planes
    for (int c = 0; c < 3; ++c) {
        if (!(edges >> c & 1))
            continue;
        const auto in_front = std::ranges::count_if(
            corners, [&](const glm::dvec3& corner) { return planes_[c].height(corner) > error_; });
        if (in_front == 0)
            return kInfinity;
        cut |= unsigned{in_front < 3} << c;
    }
    ConvexPolygon front(corners, scaled_normal(map_.mesh, other));
    for (int c = 0; c < 3 && !front.points().empty(); ++c)
        if (cut >> c & 1)
            front.clip(planes_[c].origin, planes_[c].inward, error_);
    if (front.points().size() < 3)
        return kInfinity;
    return distance(ConvexPolygon(corners_, scaled_normal(map_.mesh, face_)), front);
}

double FaceSurroundings::distance_in_front(unsigned edges, const NearbyFaces& nearby,
                                           double bound) const
{
    const Bounds<glm::vec3> box = face_box(map_.mesh, face_);
    double nearest = bound;
    for (std::size_t i = 0; i < nearby.count(); ++i) {
        const FaceId other = nearby.face(i);
        if ((nearby.front(i) & edges) != edges || other == face_ ||
            box_distance2(box, face_box(map_.mesh, other)) >= nearest * nearest)
            continue;
        nearest = std::min(nearest, distance_of(edges, other));
        if (nearest <= 2 * error_)
            return 0;
    }
    return nearest < bound ? nearest : kInfinity;
}

double FaceSurroundings::distance_in_front(unsigned edges, double bound) const
{
    struct Visit {
        FaceTree::Range range;
        float distance2;
    };
    const Bounds<glm::vec3> box = face_box(map_.mesh, face_);
    const FaceTree& tree = map_.tree;
    std::array<Visit, FaceTree::kMostDepth + 1> stack;
    std::size_t depth = 0;
    int looked_at = 0;
    double nearest = bound;
    stack[depth++] = {tree.root(), 0.0f};
    while (depth > 0) {
        const auto [range, distance2] = stack[--depth];
        if (distance2 >= nearest * nearest || behind(edges, tree.box(range)))
            continue;
        if (!tree.is_leaf(range)) {
            const auto halves = tree.children(range);
            Visit near{halves[0], box_distance2(box, tree.box(halves[0]))};
            Visit far{halves[1], box_distance2(box, tree.box(halves[1]))};
            if (far.distance2 < near.distance2)
                std::swap(near, far);
            stack[depth++] = far;
            stack[depth++] = near;
            continue;
        }
        for (const FaceId other : tree.faces(range)) {
            if (other == face_)
                continue;
            nearest = std::min(nearest, distance_of(edges, other));
            ++looked_at;
        }
        if (looked_at > kMostFaces || nearest <= 2 * error_)
            return 0;
    }
    return nearest < bound ? nearest : kInfinity;
}

} // namespace hipmap
