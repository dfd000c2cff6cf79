#include "preprocess/partition/seams.h"

#include "preprocess/partition/contact_face.h"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace hipmap {
namespace {

/// A face that touches an edge from within its plane.
struct Touch {
    FaceId face = kNone;
    std::optional<Interval> beyond; ///< of the edge, where the face goes on on its other side
};

/// Union-find over maps that also keeps which must be turned over against which.
class TurningSets {
  public:
    explicit TurningSets(std::size_t count) : parent_(count), turned_(count, 0)
    {
        for (std::uint32_t i = 0; i < count; ++i)
            parent_[i] = i;
    }

    std::pair<std::uint32_t, std::uint8_t> root(std::uint32_t map)
    {
        std::uint8_t turned = 0;
        while (parent_[map] != map) {
            const std::uint32_t up = parent_[map];
            turned_[map] ^= turned_[up]; // path halving
            parent_[map] = parent_[up];
            turned ^= turned_[map];
            map = parent_[map];
        }
        return {map, turned};
    }

    /// Returns whether both are together now: not if they already are, the other way round.
    bool unite(std::uint32_t a, std::uint32_t b, std::uint8_t turn)
    {
        const auto [root_a, turn_a] = root(a);
        const auto [root_b, turn_b] = root(b);
        const std::uint8_t between = turn_a ^ turn_b ^ turn;
        if (root_a == root_b)
            return between == 0;
        parent_[std::max(root_a, root_b)] = std::min(root_a, root_b);
        turned_[std::max(root_a, root_b)] = between;
        return true;
    }

  private:
    std::vector<std::uint32_t> parent_;
    std::vector<std::uint8_t> turned_; ///< against the parent; 0 for a root
};

class SeamSearch {
  public:
    SeamSearch(const TriangleMesh& mesh, const HalfEdges& edges, std::span<const EdgeClass> classes,
               const FaceTree& tree, double error)
        : mesh_(mesh), edges_(edges), classes_(classes), tree_(tree), error_(error)
    {
    }

    /// Whether the surface may go on across an edge although no connected edge says so.
    bool may_go_on(std::uint32_t edge) const
    {
        if (classes_[edge] == EdgeClass::unconnected) // one of two coincident faces was turned
            return edges_.flipped[edge / 3] != edges_.flipped[edges_.opposite[edge] / 3];
        return classes_[edge] == EdgeClass::border || classes_[edge] == EdgeClass::non_manifold;
    }

    std::vector<Touch> touches_of(std::uint32_t edge) const;

    glm::dvec3 start(std::uint32_t edge) const { return corner(edge / 3, edge % 3); }
    glm::dvec3 end(std::uint32_t edge) const { return corner(edge / 3, (edge % 3 + 1) % 3); }

  private:
    glm::dvec3 corner(FaceId face, std::uint32_t c) const
    {
        return glm::dvec3(mesh_.positions[mesh_.corners[face][static_cast<int>(c)]]);
    }
    bool has_edge(FaceId face, const glm::dvec3& a, const glm::dvec3& b) const
    {
        int ends = 0;
        for (std::uint32_t c = 0; c < 3; ++c)
            ends += corner(face, c) == a || corner(face, c) == b;
        return ends == 2;
    }

    const TriangleMesh& mesh_;
    const HalfEdges& edges_;
    std::span<const EdgeClass> classes_;
    const FaceTree& tree_;
    double error_;
};

std::vector<Touch> SeamSearch::touches_of(std::uint32_t edge) const
{
    std::vector<Touch> touches;
    const FaceId face = edge / 3;
    const ContactFace own(mesh_, face, error_);
    if (own.too_thin())
        return {};
    const glm::dvec3 a = start(edge);
    const glm::dvec3 b = end(edge);
    const glm::dvec3 outward = -3 * error_ * own.planes[edge % 3].inward;
    Bounds<glm::vec3> box;
    for (const glm::dvec3& p : {a, b}) {
        box.add(glm::vec3(p - 4 * error_));
        box.add(glm::vec3(p + 4 * error_));
    }
    bool crossed = false;
    const auto look_at = [&](FaceId other) {
        if (other == face || crossed)
            return;
        const ContactFace there(mesh_, other, error_);
        const bool same_plane = !there.too_thin() && parallel(own, there);
        if (!same_plane) {
            crossed |= classes_[edge] == EdgeClass::non_manifold && has_edge(other, a, b);
            return;
        }
        if (glm::dot(own.normal, there.normal) > 0 && there.part_on(a, b))
            touches.push_back({other, there.part_on(a + outward, b + outward)});
    };
    tree_.visit(
        box, [](const FaceTree::Range&) { return false; }, look_at);
    if (crossed)
        touches.clear();
    std::ranges::sort(touches, {}, &Touch::face);
    return touches;
}

/// What no interval covers of an edge, but for pieces too short to matter.
std::vector<Interval> uncovered(std::vector<Interval> covered, double least)
{
    std::ranges::sort(covered, {}, &Interval::begin);
    std::vector<Interval> open;
    double at = 0;
    for (const Interval& part : covered) {
        if (part.begin - at > least)
            open.push_back({at, part.begin});
        at = std::max(at, part.end);
    }
    if (1 - at > least)
        open.push_back({at, 1});
    return open;
}

/// Numbers the joined maps by lowest face; the root of a set is its lowest map.
SharedMaps renumber(const SharedMaps& maps, TurningSets& sets)
{
    SharedMaps out;
    std::vector<MapId> number(maps.count);
    for (MapId map = 0; map < maps.count; ++map) {
        const MapId root = sets.root(map).first;
        number[map] = root == map ? out.count++ : number[root];
    }
    out.map_of_face.reserve(maps.map_of_face.size());
    for (const MapId map : maps.map_of_face)
        out.map_of_face.push_back(map == kNone ? kNone : number[map]);
    return out;
}

} // namespace

Seams find_seams(const TriangleMesh& mesh, const HalfEdges& edges,
                 std::span<const EdgeClass> classes, const SharedMaps& maps, const FaceTree& tree,
                 double error)
{
    const SeamSearch search(mesh, edges, classes, tree, error);
    std::vector<std::uint32_t> ends; // of maps
    for (std::uint32_t edge = 0; edge < classes.size(); ++edge)
        if (search.may_go_on(edge))
            ends.push_back(edge);
    std::vector<std::vector<Touch>> touches(ends.size());
    tbb::parallel_for(std::size_t{0}, ends.size(),
                      [&](std::size_t i) { touches[i] = search.touches_of(ends[i]); });

    Seams out;
    TurningSets sets(maps.count);
    std::vector<std::vector<Interval>> covered(ends.size());
    for (std::size_t i = 0; i < ends.size(); ++i)
        for (const Touch& touch : touches[i]) {
            const FaceId face = ends[i] / 3;
            const std::uint8_t turn = edges.flipped[face] ^ edges.flipped[touch.face];
            if (sets.unite(maps.map_of_face[face], maps.map_of_face[touch.face], turn) &&
                touch.beyond)
                covered[i].push_back(*touch.beyond);
        }
    out.maps = renumber(maps, sets);
    for (MapId map = 0; map < maps.count; ++map)
        out.turned.push_back(sets.root(map).second);
    for (std::size_t i = 0; i < ends.size(); ++i) {
        if (covered[i].empty() || classes[ends[i]] == EdgeClass::unconnected)
            continue;
        out.bridged_edges.push_back(ends[i]);
        const glm::dvec3 a = search.start(ends[i]);
        const glm::dvec3 along = search.end(ends[i]) - a;
        for (const Interval& part : uncovered(covered[i], 64 * error / glm::length(along)))
            out.open_parts.push_back({out.maps.map_of_face[ends[i] / 3],
                                      glm::vec3(a + part.begin * along),
                                      glm::vec3(a + part.end * along)});
    }
    return out;
}

} // namespace hipmap
