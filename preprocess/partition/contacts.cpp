#include "preprocess/partition/contacts.h"

#include "preprocess/partition/contact_face.h"
#include "preprocess/partition/leaf_neighbours.h"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <tuple>

namespace hipmap {
namespace {

/// More faces than this that meet one are not looked at: a bound for files made to have too many.
constexpr int kMostPairs = 1024;

auto key_of(const MapContact& c)
{
    return std::tie(c.map, c.a.x, c.a.y, c.a.z, c.b.x, c.b.y, c.b.z);
}

auto key_of(const MadeContact& c)
{
    return std::tuple_cat(key_of(c.contact), std::tie(c.by));
}

template <typename Contact>
void sort_without_twins(std::vector<Contact>& contacts)
{
    tbb::parallel_sort(contacts.begin(), contacts.end(),
                       [](const Contact& l, const Contact& r) { return key_of(l) < key_of(r); });
    contacts.erase(std::unique(contacts.begin(), contacts.end()), contacts.end());
}

bool before(const glm::dvec3& a, const glm::dvec3& b)
{
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
}

bool is_boundary(const ContactScene& scene, std::uint32_t edge)
{
    return scene.edge_class[edge] != EdgeClass::connected &&
           !std::ranges::binary_search(scene.bridged_edges, edge);
}

/// Which edges of a face a line on it runs along, as bits.
unsigned edges_along(const ContactFace& shape, const ContactLine& line)
{
    unsigned edges = 0;
    for (int c = 0; c < 3; ++c)
        edges |= unsigned{std::abs(shape.planes[c].height(line.a)) <= 2 * shape.error &&
                          std::abs(shape.planes[c].height(line.b)) <= 2 * shape.error}
                 << c;
    return edges;
}

int shared_corners(const TriangleMesh& mesh, FaceId f, FaceId g)
{
    const glm::uvec3 &of_f = mesh.corners[f], &of_g = mesh.corners[g];
    int count = 0;
    for (int c = 0; c < 3; ++c) {
        const glm::vec3& p = mesh.positions[of_f[c]];
        count += (p == mesh.positions[of_g.x]) | (p == mesh.positions[of_g.y]) |
                 (p == mesh.positions[of_g.z]);
    }
    return count;
}

/// Where the edges of `g` stand on `f`.
class Standing {
  public:
    Standing(const ContactScene& scene, FaceId f, const ContactFace& shape, FaceId g,
             const ContactFace& on_it)
        : scene_(scene), f_(f), g_(g), shape_(shape), standing_(on_it),
          flat_(parallel(shape, on_it))
    {
    }

    /// Appends the lines and returns the length of the longest one there is, wanted or not.
    double append(std::vector<MapContact>& out) const
    {
        double longest = 0;
        for (std::uint32_t c = 0; c < 3; ++c)
            longest = std::max(longest, append_edge(c, out));
        return longest;
    }

  private:
    double append_edge(std::uint32_t c, std::vector<MapContact>& out) const
    {
        // Both faces of an edge must give the same line.
        glm::dvec3 a = standing_.corners[c];
        glm::dvec3 b = standing_.corners[(c + 1) % 3];
        if (before(b, a))
            std::swap(a, b);
        const std::optional<Interval> part = shape_.part_on(a, b);
        if (!part)
            return 0;
        const ContactLine line{part->begin > 0 ? a + part->begin * (b - a) : a,
                               part->end < 1 ? a + part->end * (b - a) : b};
        const std::uint32_t edge = 3 * g_ + c;
        const MapId own = scene_.map_of_face[g_];
        const MapId map = scene_.map_of_face[f_];
        const std::uint32_t twin = scene_.opposite[edge];
        const bool ends = is_boundary(scene_, edge);
        const bool known = own == map || (twin != kNone && scene_.map_of_face[twin / 3] == map);
        const unsigned along = edges_along(shape_, line);
        bool along_end = false;
        for (std::uint32_t side = 0; side < 3; ++side)
            along_end |= (along >> side & 1) && is_boundary(scene_, 3 * f_ + side);
        if ((ends || !flat_) && !known && !along_end)
            out.push_back({map, glm::vec3(line.a), glm::vec3(line.b)});
        // Where two edges meet, the other one says the same.
        if (!ends && !flat_ && along == 0)
            out.push_back({own, glm::vec3(line.a), glm::vec3(line.b)});
        return glm::length(line.b - line.a);
    }

    const ContactScene& scene_;
    FaceId f_, g_;
    const ContactFace& shape_;
    const ContactFace& standing_;
    bool flat_;
};

/// [F] 1: of a map that is wanted, or so near one that it may meet it, within twice what is looked
/// through from a face.
std::vector<std::uint8_t> faces_near(const ContactScene& scene, const FaceTree& tree,
                                     std::span<const std::uint8_t> wanted)
{
    const auto face_count = static_cast<FaceId>(scene.mesh.face_count());
    std::vector<std::uint8_t> near(face_count, 1);
    if (std::ranges::count(wanted, 0) == 0)
        return near;
    std::ranges::fill(near, 0);
    for (FaceId face = 0; face < face_count; ++face) {
        if (scene.map_of_face[face] == kNone || wanted[scene.map_of_face[face]] == 0)
            continue;
        near[face] = 1;
        const Bounds<glm::vec3> box = widened(face_box(scene.mesh, face), 8 * scene.error);
        tree.visit(
            box, [](const FaceTree::Range&) { return false; },
            [&](FaceId other) { near[other] |= meet(box, face_box(scene.mesh, other)); });
    }
    return near;
}

/// Whether a pair of faces is looked at from `f`: from the smaller one, as a floor may meet any
/// number of small things, but few large ones meet a small one.
bool is_smaller(const BoxedFace& f, const BoxedFace& g)
{
    const glm::vec3 extent_f = f.box.extent(), extent_g = g.box.extent();
    const float size_f = glm::dot(extent_f, extent_f), size_g = glm::dot(extent_g, extent_g);
    return size_f < size_g || (size_f == size_g && f.face < g.face);
}

/// A face and its shape.
struct ShapedFace {
    FaceId face;
    const ContactFace& shape;
};

/// Whether two faces share so many corners that they have no contact.
bool share_boundary(const ContactScene& scene, FaceId f, FaceId g)
{
    const bool one_map = scene.map_of_face[f] == scene.map_of_face[g];
    return shared_corners(scene.mesh, f, g) > (one_map ? 0 : 1);
}

/// Appends the contacts of two faces that do not share a boundary.
void append_contacts(const ContactScene& scene, const ShapedFace& f, const ShapedFace& g,
                     std::vector<MapContact>& out)
{
    const bool one_map = scene.map_of_face[f.face] == scene.map_of_face[g.face];
    if (f.shape.too_thin() || g.shape.too_thin() || (one_map && parallel(f.shape, g.shape)))
        return;
    const double standing = std::max(Standing(scene, f.face, f.shape, g.face, g.shape).append(out),
                                     Standing(scene, g.face, g.shape, f.face, f.shape).append(out));
    std::optional<ContactLine> line = crossing(f.shape, g.shape);
    if (!line || standing > 0.5 * glm::length(line->b - line->a))
        return;
    if (before(line->b, line->a)) // so that a face coincident with one of them gives the same
        std::swap(line->a, line->b);
    for (const FaceId face : {f.face, g.face})
        out.push_back({scene.map_of_face[face], glm::vec3(line->a), glm::vec3(line->b)});
}

/// Finds the contacts of pairs (f, g) of faces whose boxes meet.  A face f takes part if
/// `starts(f)`, a face g if `wanted(f, g)` and no node above it has `skip(range, map of f)`.  The
/// faces f of a leaf are looked at together.
template <typename Starts, typename Skip, typename Wanted>
class LeafContacts {
  public:
    LeafContacts(const ContactScene& scene, const FaceTree& tree, const Starts& starts,
                 const Skip& skip, const Wanted& wanted)
        : scene_(scene), tree_(tree), starts_(starts), skip_(skip), wanted_(wanted)
    {
    }

    void find(const FaceTree::Range& leaf)
    {
        members_.clear();
        Bounds<glm::vec3> box;
        for (const FaceId f : tree_.faces(leaf))
            if (scene_.map_of_face[f] != kNone && starts_(f)) {
                members_.push_back({f, face_box(scene_.mesh, f)});
                const Bounds<glm::vec3> wide = widened(members_.back().box, 4 * scene_.error);
                box.add(wide.low);
                box.add(wide.high);
            }
        if (members_.empty())
            return;
        const bool gathered =
            near_.gather(scene_.mesh, tree_, box, [&](const FaceTree::Range& range) {
                return std::ranges::all_of(members_, [&](const BoxedFace& member) {
                    return skip_(range, scene_.map_of_face[member.face]);
                });
            });
        for (const BoxedFace& member : members_)
            find_of(member, gathered);
    }

    FoundContacts take() { return std::move(found_); }

  private:
    void find_of(const BoxedFace& f, bool gathered)
    {
        const Bounds<glm::vec3> box = widened(f.box, 4 * scene_.error);
        shape_.reset();
        pairs_ = 0;
        if (gathered)
            near_.visit(box, [&](const BoxedFace& g) {
                look_at(f, g);
                return pairs_ <= kMostPairs;
            });
        else
            tree_.visit(
                box,
                [&](const FaceTree::Range& range) {
                    return pairs_ > kMostPairs || skip_(range, scene_.map_of_face[f.face]);
                },
                [&](FaceId face) {
                    const BoxedFace g{face, face_box(scene_.mesh, face)};
                    if (meet(box, g.box))
                        look_at(f, g);
                });
        found_.given_up += pairs_ > kMostPairs;
    }

    void look_at(const BoxedFace& f, const BoxedFace& g)
    {
        if (!wanted_(f, g) || ++pairs_ > kMostPairs || share_boundary(scene_, f.face, g.face))
            return;
        if (!shape_)
            shape_.emplace(scene_.mesh, f.face, scene_.error);
        const ContactFace other(scene_.mesh, g.face, scene_.error);
        const ShapedFace first{f.face, *shape_}, second{g.face, other};
        lines_.clear();
        append_contacts(scene_, f.face < g.face ? first : second, f.face < g.face ? second : first,
                        lines_);
        const MapId of_f = scene_.map_of_face[f.face], of_g = scene_.map_of_face[g.face];
        for (const MapContact& line : lines_)
            found_.contacts.push_back({line, line.map == of_f ? of_g : of_f});
    }

    const ContactScene& scene_;
    const FaceTree& tree_;
    const Starts& starts_;
    const Skip& skip_;
    const Wanted& wanted_;
    FoundContacts found_;
    std::vector<BoxedFace> members_; ///< faces f of the leaf
    LeafNeighbours near_;
    std::optional<ContactFace> shape_; ///< of the face f that is looked at; made when needed
    int pairs_ = 0;                    ///< of that face
    std::vector<MapContact> lines_;
};

/// What LeafContacts finds in all leaves, sorted.
template <typename Starts, typename Skip, typename Wanted>
FoundContacts contacts_of_pairs(const ContactScene& scene, const FaceTree& tree,
                                const Starts& starts, const Skip& skip, const Wanted& wanted)
{
    auto searches =
        search_leaves(tree, [&] { return LeafContacts(scene, tree, starts, skip, wanted); });
    FoundContacts out;
    for (auto& some : searches) {
        const FoundContacts found = some.take();
        out.contacts.insert(out.contacts.end(), found.contacts.begin(), found.contacts.end());
        out.given_up += found.given_up;
    }
    sort_contacts(out.contacts);
    return out;
}

} // namespace

void append_contacts(const ContactScene& scene, FaceId f, FaceId g, std::vector<MapContact>& out)
{
    if (share_boundary(scene, f, g))
        return;
    const ContactFace shape_f(scene.mesh, f, scene.error);
    const ContactFace shape_g(scene.mesh, g, scene.error);
    append_contacts(scene, ShapedFace{f, shape_f}, ShapedFace{g, shape_g}, out);
}

void sort_contacts(std::vector<MapContact>& contacts)
{
    sort_without_twins(contacts);
}

void sort_contacts(std::vector<MadeContact>& contacts)
{
    sort_without_twins(contacts);
}

FoundContacts find_contacts(const ContactScene& scene, const FaceTree& tree,
                            std::span<const std::uint8_t> wanted)
{
    const auto& map_of_face = scene.map_of_face;
    const std::vector<MapId> map_of_node = tree.labels_of_nodes(map_of_face);
    const std::vector<std::uint8_t> starts = faces_near(scene, tree, wanted);
    return contacts_of_pairs(
        scene, tree, [&](FaceId face) { return starts[face] != 0; },
        [&](const FaceTree::Range& range, MapId map) { return map_of_node[range.node] == map; },
        [&](const BoxedFace& f, const BoxedFace& g) {
            return map_of_face[f.face] != map_of_face[g.face] && is_smaller(f, g);
        });
}

FoundContacts find_own_contacts(const ContactScene& scene, const FaceTree& tree,
                                std::span<const float> self_distance,
                                std::span<const std::uint8_t> wanted)
{
    const auto& map_of_face = scene.map_of_face;
    const std::vector<MapId> map_of_node = tree.labels_of_nodes(map_of_face);
    // What stands on a face or cuts through it is in front of all of its planes.
    const auto is_met = [&](FaceId face) { return self_distance[face] <= scene.error; };
    return contacts_of_pairs(
        scene, tree, [&](FaceId face) { return wanted[map_of_face[face]] != 0 && is_met(face); },
        [&](const FaceTree::Range& range, MapId map) {
            return map_of_node[range.node] != map && map_of_node[range.node] != kNone;
        },
        [&](const BoxedFace& f, const BoxedFace& g) {
            return f.face != g.face && map_of_face[f.face] == map_of_face[g.face] &&
                   (!is_met(g.face) || is_smaller(f, g));
        });
}

} // namespace hipmap
