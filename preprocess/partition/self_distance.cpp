#include "preprocess/partition/self_distance.h"

#include "common/math/bounds.h"
#include "common/scene/store_copies.h"
#include "preprocess/partition/face_surroundings.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace hipmap {
namespace {

/// The rounding bound of a point computed from a face's corners in float, per unit of the largest
/// coordinate: three axes with seven roundings each stay below it.
constexpr double kPositionError = 0x1p-20;

/// Sets of edges as bits, smaller sets first.
constexpr std::array<unsigned, 8> kEdgeSets{0, 1, 2, 4, 3, 5, 6, 7};

struct FaceSelfDistance {
    unsigned edges = 0;
    double self_distance = 0.0;
};

/// A face of a leaf.
struct Member {
    FaceSurroundings around;
    unsigned connected; ///< edges
    double height;      ///< over their planes: the largest bound there can be
};

/// The set of edges, of those with all connected ones, with the largest limiting radius.
/// distance(edges, bound): as FaceSurroundings::distance_in_front.
template <typename Distance>
FaceSelfDistance choose_edges(const Member& face, double error, const Distance& distance)
{
    FaceSelfDistance chosen;
    double best = 0;
    for (const unsigned edges : kEdgeSets) {
        if ((edges & face.connected) !=
            face.connected) // what lies across such an edge touches the face
            continue;
        const double height =
            edges == face.connected ? face.height : face.around.largest_height(edges);
        if (!(height - 2 * error > best)) // or not a number: a face too small for double
            continue;
        const double self_distance = std::max(0.0, distance(edges, height) - 2 * error);
        const double radius = std::min(height - 2 * error, self_distance);
        if (radius > best) {
            best = radius;
            chosen = {edges, self_distance};
        }
    }
    return chosen;
}

/// Finds the self-distances of the faces of leaves, one after the other.  The faces of a leaf look
/// at about the same faces, so these are gathered once, if they are not too many.
class LeafSelfDistances {
  public:
    LeafSelfDistances(const MapTree& map, std::span<const EdgeClass> edge_class, double error)
        : map_(map), edge_class_(edge_class), error_(error)
    {
    }

    void find(const FaceTree::Range& leaf, SelfDistances& out);

  private:
    void add_member(FaceId face);
    /// Gathers what is within `radius` of the leaf.  Returns false if that is too much.
    bool gather(const FaceTree::Range& leaf, double radius);
    FaceSelfDistance self_distance_of(const Member& member, bool gathered_all);

    MapTree map_;
    std::span<const EdgeClass> edge_class_;
    double error_;
    std::vector<Member> members_;
    NearbyFaces nearby_;
};

void LeafSelfDistances::add_member(FaceId face)
{
    unsigned connected = 0;
    for (unsigned c = 0; c < 3; ++c)
        connected |= unsigned{edge_class_[std::size_t{3} * face + c] == EdgeClass::connected} << c;
    members_.push_back({FaceSurroundings(map_, face, error_), connected, 0.0});
    Member& member = members_.back();
    member.height = member.around.largest_height(connected);
}

bool LeafSelfDistances::gather(const FaceTree::Range& leaf, double radius)
{
    Bounds<glm::vec3> box = map_.tree.box(leaf);
    box.low = glm::vec3(glm::dvec3(box.low) - radius - error_);
    box.high = glm::vec3(glm::dvec3(box.high) + radius + error_);
    bool room = true;
    nearby_.clear();
    map_.tree.visit(
        box, [&](const FaceTree::Range&) { return !room; },
        [&](FaceId face) { room = room && nearby_.add(map_.mesh, face, box); });
    return room;
}

FaceSelfDistance LeafSelfDistances::self_distance_of(const Member& member, bool gathered_all)
{
    const FaceSurroundings& around = member.around;
    if (!gathered_all)
        return choose_edges(member, error_, [&](unsigned edges, double bound) {
            return around.distance_in_front(edges, bound);
        });
    nearby_.sort_out(around.planes(), error_);
    return choose_edges(member, error_, [&](unsigned edges, double bound) {
        return around.distance_in_front(edges, nearby_, bound);
    });
}

void LeafSelfDistances::find(const FaceTree::Range& leaf, SelfDistances& out)
{
    const std::span<const FaceId> faces = map_.tree.faces(leaf);
    members_.clear();
    double radius = 0;
    for (const FaceId face : faces) {
        add_member(face);
        if (members_.back().height < std::numeric_limits<double>::infinity())
            radius = std::max(radius, members_.back().height);
    }
    const bool gathered = gather(leaf, radius);
    for (std::size_t i = 0; i < faces.size(); ++i) {
        const bool gathered_all = gathered && members_[i].height <= radius;
        const FaceSelfDistance found = self_distance_of(members_[i], gathered_all);
        out.kept_edges[faces[i]] = static_cast<std::uint8_t>(found.edges);
        out.self_distance[faces[i]] = static_cast<float>(found.self_distance);
    }
}

} // namespace

float position_error_of(const TriangleMesh& mesh)
{
    const Bounds<glm::vec3> box = bounds_of(mesh);
    if (box.empty())
        return 0;
    const glm::vec3 away = glm::max(glm::abs(box.low), glm::abs(box.high));
    const float largest = std::max({away.x, away.y, away.z});
    return static_cast<float>(kPositionError * largest);
}

void find_self_distances(const MapTree& map, std::span<const EdgeClass> edge_class,
                         double position_error, SelfDistances& out)
{
    const std::span<const FaceId> faces = map.tree.faces(map.tree.root());
    if (faces.size() == 1) {
        out.kept_edges[faces[0]] = 0;
        out.self_distance[faces[0]] = std::numeric_limits<float>::infinity();
        return;
    }
    tbb::parallel_for(tbb::blocked_range<std::uint32_t>(0, map.tree.leaf_count()),
                      [&](const auto& leaves) {
                          LeafSelfDistances self_distances(map, edge_class, position_error);
                          for (std::uint32_t i = leaves.begin(); i < leaves.end(); ++i)
                              self_distances.find(map.tree.leaf(i), out);
                      });
}

} // namespace hipmap
