#include "preprocess/partition/clearance.h"

#include "common/partition/limiting_radius.h"
#include "preprocess/partition/face_tree.h"
#include "preprocess/partition/polygon_distance.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace hipmap {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A face whose clearance takes more faces than this is given up.
constexpr int kMostFaces = 4096;

/// Of a point that is computed from a face's corners in float, per unit of the largest coordinate:
/// three axes with seven roundings each stay below it.
constexpr double kPositionError = 0x1p-20;

/// Sets of edges as bits, smaller sets first.
constexpr std::array<unsigned, 8> kEdgeSets{0, 1, 2, 4, 3, 5, 6, 7};

ConvexPolygon polygon_of(const TriangleMesh& mesh, FaceId face)
{
    const glm::uvec3 c = mesh.corners[face];
    return {{glm::dvec3(mesh.positions[c.x]), glm::dvec3(mesh.positions[c.y]),
             glm::dvec3(mesh.positions[c.z])},
            scaled_normal(mesh, face)};
}

/// Square of the distance between two boxes, or a little less.
float box_distance2(const Bounds<glm::vec3>& a, const Bounds<glm::vec3>& b)
{
    constexpr float kRounding = 1 - 1e-6f;
    const glm::vec3 off = glm::max(glm::max(a.low - b.high, b.low - a.high), glm::vec3(0.0f));
    return kRounding * glm::dot(off, off);
}

/// A face with the planes through its edges, among the faces of its shared map.
class FaceSurroundings {
  public:
    FaceSurroundings(const TriangleMesh& mesh, const FaceTree& tree, FaceId face, double error)
        : mesh_(mesh), tree_(tree), face_(face), error_(error), polygon_(polygon_of(mesh, face)),
          box_(face_box(mesh, face))
    {
        for (int c = 0; c < 3; ++c)
            planes_[c] = edge_plane(mesh, face, c);
    }

    /// Largest height over the nearest of the chosen planes, of any point of the face.
    double largest_height(unsigned edges) const;

    /// Distance of the face from the map's other faces in front of the chosen planes; infinity if
    /// it is not below `bound`, 0 if finding it takes too long.
    double distance_in_front(unsigned edges, FaceTree::Range root, double bound) const;

  private:
    bool behind(unsigned edges, const Bounds<glm::vec3>& box) const;
    double distance_of(unsigned edges, FaceId other) const;

    const TriangleMesh& mesh_;
    const FaceTree& tree_;
    FaceId face_;
    double error_;
    ConvexPolygon polygon_;
    Bounds<glm::vec3> box_;
    std::array<EdgePlane, 3> planes_;
};

double FaceSurroundings::largest_height(unsigned edges) const
{
    const std::span<const glm::dvec3> p = polygon_.points();
    std::array<double, 3> length;  // of edges
    std::array<double, 3> highest; // over each plane: the corner across
    for (int c = 0; c < 3; ++c) {
        length[c] = glm::length(p[(c + 1) % 3] - p[c]);
        highest[c] = planes_[c].height(p[(c + 2) % 3]);
    }
    if (edges == 0)
        return kInfinity;
    if (std::has_single_bit(edges))
        return highest[std::countr_zero(edges)];
    if (edges == 7)
        return length[0] * highest[0] / (length[0] + length[1] + length[2]);
    // On the third edge the height over one plane falls from its highest to 0 as the other rises.
    const int open = std::countr_zero(~edges & 7u);
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
    const glm::uvec3 corners = mesh_.corners[other];
    unsigned cut = 0; // by which planes
    for (int c = 0; c < 3; ++c) {
        if (!(edges >> c & 1))
            continue;
        int in_front = 0;
        for (int corner = 0; corner < 3; ++corner)
            in_front += planes_[c].height(glm::dvec3(mesh_.positions[corners[corner]])) > error_;
        if (in_front == 0)
            return kInfinity;
        cut |= unsigned{in_front < 3} << c;
    }
    ConvexPolygon front = polygon_of(mesh_, other);
    for (int c = 0; c < 3 && !front.points().empty(); ++c)
        if (cut >> c & 1)
            front.clip(planes_[c].origin, planes_[c].inward, error_);
    return front.points().size() < 3 ? kInfinity : distance(polygon_, front);
}

double FaceSurroundings::distance_in_front(unsigned edges, FaceTree::Range root, double bound) const
{
    struct Visit {
        FaceTree::Range range;
        float distance2;
    };
    std::array<Visit, 40> stack; // halving 2^32 faces goes 32 deep
    std::size_t depth = 0;
    int looked_at = 0;
    double nearest = bound;
    stack[depth++] = {root, 0.0f};
    while (depth > 0) {
        const auto [range, distance2] = stack[--depth];
        if (distance2 >= nearest * nearest || behind(edges, tree_.box(range)))
            continue;
        if (!range.leaf()) {
            const auto halves = tree_.children(range);
            Visit left{halves[0], box_distance2(box_, tree_.box(halves[0]))};
            Visit right{halves[1], box_distance2(box_, tree_.box(halves[1]))};
            if (right.distance2 < left.distance2)
                std::swap(left, right);
            if (right.distance2 < nearest * nearest)
                stack[depth++] = right;
            if (left.distance2 < nearest * nearest)
                stack[depth++] = left;
            continue;
        }
        for (const FaceId other : tree_.faces(range))
            if (other != face_)
                nearest = std::min(nearest, distance_of(edges, other));
        looked_at += static_cast<int>(range.end - range.begin);
        if (looked_at > kMostFaces || nearest <= 2 * error_)
            return 0;
    }
    return nearest < bound ? nearest : kInfinity;
}

struct FaceClearance {
    unsigned edges = 0;
    double clearance = 0.0;
};

/// The set of edges, of those with all connected ones, with the largest limiting radius.
FaceClearance choose_edges(const FaceSurroundings& around, unsigned connected, double error,
                           FaceTree::Range root)
{
    FaceClearance chosen;
    double best = 0;
    for (const unsigned edges : kEdgeSets) {
        if ((edges & connected) != connected) // what lies across such an edge touches the face
            continue;
        const double height = around.largest_height(edges);
        if (!(height - 2 * error > best)) // or not a number: a face too small for double
            continue;
        const double found = around.distance_in_front(edges, root, height);
        const double clearance = std::max(0.0, found - 2 * error);
        const double radius = std::min(height - 2 * error, clearance);
        if (radius > best) {
            best = radius;
            chosen = {edges, clearance};
        }
    }
    return chosen;
}

} // namespace

float position_error_of(const TriangleMesh& mesh)
{
    float largest = 0;
    for (const glm::vec3& p : mesh.positions)
        largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    return static_cast<float>(kPositionError * largest);
}

Clearances find_clearances(const TriangleMesh& mesh, std::span<const EdgeClass> edge_class,
                           const SharedMaps& maps, double position_error)
{
    Clearances out;
    out.kept_edges.assign(mesh.face_count(), 0);
    out.clearance.assign(mesh.face_count(), 0.0f);
    const FaceTree tree(mesh, maps.map_of_face, maps.count);
    tbb::parallel_for(std::size_t{0}, mesh.face_count(), [&](std::size_t face) {
        const MapId map = maps.map_of_face[face];
        if (map == kNone)
            return;
        unsigned connected = 0;
        for (unsigned c = 0; c < 3; ++c)
            connected |= unsigned{edge_class[3 * face + c] == EdgeClass::connected} << c;
        const FaceSurroundings around(mesh, tree, static_cast<FaceId>(face), position_error);
        const FaceClearance chosen =
            choose_edges(around, connected, position_error, tree.root(map));
        out.kept_edges[face] = static_cast<std::uint8_t>(chosen.edges);
        out.clearance[face] = static_cast<float>(chosen.clearance);
    });
    return out;
}

} // namespace hipmap
