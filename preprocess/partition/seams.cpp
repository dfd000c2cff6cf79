#include "preprocess/partition/seams.h"

#include "preprocess/partition/contact_face.h"
#include "preprocess/partition/leaf_neighbours.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>

namespace hipmap {
namespace {

/// More faces than this near an edge are not looked at: a bound for files made to have too many.
constexpr int kMostLookedAt = 1024;

/// More faces than this that touch an edge join nothing more: enough to hold a stack together.
constexpr std::size_t kMostTouches = 256;

/// Edges whose touches are held at a time.
constexpr std::size_t kEdgesAtOnce = 1 << 14;

/// A face that touches an edge from within its plane.
struct Touch {
    FaceId face = kNone;
    std::optional<Interval> beyond; ///< of the edge, where the face goes on on its other side
};

struct Touches {
    std::vector<Touch> of; ///< by face
    bool given_up = false; ///< there may be more
};

/// Whether a segment comes into a box; a margin of `error` covers rounding.
bool passes(const Bounds<glm::vec3>& box, const glm::dvec3& a, const glm::dvec3& b, double error)
{
    const glm::dvec3 along = b - a;
    double begin = 0, end = 1;
    for (int axis = 0; axis < 3; ++axis) {
        const double low = box.low[axis] - error - a[axis];
        const double high = box.high[axis] + error - a[axis];
        if (along[axis] == 0) {
            if (low > 0 || high < 0)
                return false;
            continue;
        }
        const double t0 = low / along[axis], t1 = high / along[axis];
        begin = std::max(begin, std::min(t0, t1));
        end = std::min(end, std::max(t0, t1));
    }
    return begin <= end;
}

/// The box of a segment and of what lies within `margin` of its ends.
Bounds<glm::vec3> box_about(const glm::dvec3& a, const glm::dvec3& b, double margin)
{
    return {glm::vec3(glm::min(a, b) - margin), glm::vec3(glm::max(a, b) + margin)};
}

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
    explicit SeamSearch(const SeamScene& scene) : scene_(scene) {}

    /// Whether the surface may go on across an edge although no connected edge says so.
    bool may_go_on(std::uint32_t edge) const
    {
        const EdgeClass own = scene_.classes[edge];
        const HalfEdges& edges = scene_.edges;
        if (own == EdgeClass::unconnected) // one of two coincident faces was turned
            return edges.flipped[edge / 3] != edges.flipped[edges.opposite[edge] / 3];
        return own == EdgeClass::border || own == EdgeClass::non_manifold;
    }

    Touches touches_of(std::uint32_t edge) const;

    /// Returns false only if touches_of(edge) finds nothing and gives nothing up. own: the edge's
    /// face.  near: all faces that touches_of may look at, and others.
    bool may_touch(std::uint32_t edge, const ContactFace& own, LeafNeighbours& near) const;

    glm::dvec3 start(std::uint32_t edge) const { return corner(edge / 3, edge % 3); }
    glm::dvec3 end(std::uint32_t edge) const { return corner(edge / 3, (edge % 3 + 1) % 3); }

  private:
    glm::dvec3 corner(FaceId face, std::uint32_t c) const
    {
        return glm::dvec3(scene_.mesh.positions[scene_.mesh.corners[face][static_cast<int>(c)]]);
    }
    bool has_edge(FaceId face, const glm::dvec3& a, const glm::dvec3& b) const
    {
        int ends = 0;
        for (std::uint32_t c = 0; c < 3; ++c)
            ends += corner(face, c) == a || corner(face, c) == b;
        return ends == 2;
    }

    const SeamScene& scene_;
};

Touches SeamSearch::touches_of(std::uint32_t edge) const
{
    Touches touches;
    const FaceId face = edge / 3;
    const ContactFace own(scene_.mesh, face, scene_.error);
    if (own.too_thin())
        return {};
    const glm::dvec3 a = start(edge);
    const glm::dvec3 b = end(edge);
    const glm::dvec3 outward = -3 * scene_.error * own.planes[edge % 3].inward;
    const Bounds<glm::vec3> box = box_about(a, b, 4 * scene_.error);
    bool crossed = false;
    int looked_at = 0;
    const auto look_at = [&](FaceId other) {
        if (other == face || touches.given_up)
            return;
        const Bounds<glm::vec3> there_box = face_box(scene_.mesh, other);
        if (!meet(box, there_box) || !passes(there_box, a, b, 4 * scene_.error))
            return;
        touches.given_up = ++looked_at > kMostLookedAt;
        const ContactFace there(scene_.mesh, other, scene_.error);
        if (there.too_thin() || !parallel(own, there)) {
            crossed |= scene_.classes[edge] == EdgeClass::non_manifold && has_edge(other, a, b);
            return;
        }
        if (!(glm::dot(own.normal, there.normal) > 0 && there.part_on(a, b)))
            return;
        if (touches.of.size() == kMostTouches)
            touches.given_up = true;
        else
            touches.of.push_back({other, there.part_on(a + outward, b + outward)});
    };
    const auto skip = [&](const FaceTree::Range& range) {
        return touches.given_up || !passes(scene_.tree.box(range), a, b, 4 * scene_.error);
    };
    scene_.tree.visit(box, skip, look_at);
    if (crossed)
        touches.of.clear();
    std::ranges::sort(touches.of, {}, &Touch::face);
    return touches;
}

bool SeamSearch::may_touch(std::uint32_t edge, const ContactFace& own, LeafNeighbours& near) const
{
    const glm::dvec3 a = start(edge);
    const glm::dvec3 b = end(edge);
    const Bounds<glm::vec3> box = box_about(a, b, 4 * scene_.error);
    int looked_at = 0;
    bool found = false;
    near.visit(box, [&](const BoxedFace& other) {
        if (other.face == edge / 3 || !passes(other.box, a, b, 4 * scene_.error))
            return true;
        const ContactFace there(scene_.mesh, other.face, scene_.error);
        found = ++looked_at > kMostLookedAt ||
                (!there.too_thin() && parallel(own, there) &&
                 glm::dot(own.normal, there.normal) > 0 && there.part_on(a, b));
        return !found;
    });
    return found;
}

/// Finds edges across which a surface may go on, and that may touch a face, leaf by leaf.
class LeafEnds {
  public:
    LeafEnds(const SeamScene& scene, const SeamSearch& search) : scene_(scene), search_(search) {}

    void find(const FaceTree::Range& leaf)
    {
        members_.clear();
        Bounds<glm::vec3> box;
        for (const FaceId face : scene_.tree.faces(leaf))
            for (std::uint32_t edge = 3 * face; edge < 3 * face + 3; ++edge)
                if (search_.may_go_on(edge)) {
                    members_.push_back(edge);
                    const auto of_edge =
                        box_about(search_.start(edge), search_.end(edge), 4 * scene_.error);
                    box.add(of_edge.low);
                    box.add(of_edge.high);
                }
        if (members_.empty())
            return;
        if (!near_.gather(scene_.mesh, scene_.tree, box,
                          [](const FaceTree::Range&) { return false; })) {
            ends_.insert(ends_.end(), members_.begin(), members_.end());
            return;
        }
        for (const std::uint32_t edge : members_) {
            if (!own_ || edge / 3 != own_face_)
                own_.emplace(scene_.mesh, own_face_ = edge / 3, scene_.error);
            if (!own_->too_thin() && search_.may_touch(edge, *own_, near_))
                ends_.push_back(edge);
        }
    }

    const std::vector<std::uint32_t>& ends() const { return ends_; }

  private:
    const SeamScene& scene_;
    const SeamSearch& search_;
    std::vector<std::uint32_t> ends_;
    std::vector<std::uint32_t> members_; ///< edges of the leaf
    LeafNeighbours near_;
    FaceId own_face_ = kNone;
    std::optional<ContactFace> own_; ///< of that face
};

/// The edges beyond which a surface may go on, ascending; most of those that touch nothing are left
/// out.
std::vector<std::uint32_t> find_ends(const SeamScene& scene, const SeamSearch& search)
{
    const auto found = search_leaves(scene.tree, [&] { return LeafEnds(scene, search); });
    std::vector<std::uint32_t> ends;
    for (const LeafEnds& some : found)
        ends.insert(ends.end(), some.ends().begin(), some.ends().end());
    tbb::parallel_sort(ends.begin(), ends.end());
    return ends;
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

/// Joins the map of a face with those that touch one of its edges; returns which parts of the edge
/// the joined maps cover.
std::vector<Interval> join_across(FaceId face, std::span<const Touch> touches,
                                  std::span<const std::uint8_t> flipped, const SharedMaps& maps,
                                  TurningSets& sets)
{
    std::vector<Interval> covered;
    for (const Touch& touch : touches) {
        const std::uint8_t turn = flipped[face] ^ flipped[touch.face];
        if (sets.unite(maps.map_of_face[face], maps.map_of_face[touch.face], turn) && touch.beyond)
            covered.push_back(*touch.beyond);
    }
    return covered;
}

/// Notes a bridged edge and what is open of it, as contacts of its face instead of a map.
void bridge(const SeamSearch& search, std::uint32_t edge, const std::vector<Interval>& covered,
            double error, Seams& out)
{
    out.bridged_edges.push_back(edge);
    const glm::dvec3 a = search.start(edge);
    const glm::dvec3 along = search.end(edge) - a;
    for (const Interval& part : uncovered(covered, 64 * error / glm::length(along)))
        out.open_parts.push_back(
            {edge / 3, glm::vec3(a + part.begin * along), glm::vec3(a + part.end * along)});
}

} // namespace

Seams find_seams(const SeamScene& scene, const SharedMaps& maps)
{
    const SeamSearch search(scene);
    const std::vector<std::uint32_t> ends = find_ends(scene, search);
    Seams out;
    TurningSets sets(maps.count);
    std::vector<Touches> touches(kEdgesAtOnce);
    for (std::size_t first = 0; first < ends.size(); first += kEdgesAtOnce) {
        const std::size_t count = std::min(kEdgesAtOnce, ends.size() - first);
        tbb::parallel_for(std::size_t{0}, count,
                          [&](std::size_t i) { touches[i] = search.touches_of(ends[first + i]); });
        for (std::size_t i = 0; i < count; ++i) {
            const std::uint32_t edge = ends[first + i];
            const std::vector<Interval> covered =
                join_across(edge / 3, touches[i].of, scene.edges.flipped, maps, sets);
            if (!covered.empty() && scene.classes[edge] != EdgeClass::unconnected)
                bridge(search, edge, covered, scene.error, out);
            out.given_up += touches[i].given_up;
        }
    }
    out.maps = renumber(maps, sets);
    for (MapId map = 0; map < maps.count; ++map)
        out.turned.push_back(sets.root(map).second);
    for (MapContact& part : out.open_parts)
        part.map = out.maps.map_of_face[part.map];
    return out;
}

} // namespace hipmap
