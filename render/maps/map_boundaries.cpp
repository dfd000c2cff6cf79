#include "render/maps/map_boundaries.h"

#include "common/math/bounds.h"
#include "render/maps/straight_chains.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <tuple>
#include <utility>

namespace hipmap {

namespace {

bool is_boundary(EdgeClass edge_class)
{
    return edge_class == EdgeClass::unconnected || edge_class == EdgeClass::border ||
           edge_class == EdgeClass::non_manifold;
}

/// The map whose boundary this edge (3 face + corner) adds to, or kNone.
MapId map_bounded_by(const Partition& partition, std::uint32_t edge)
{
    const MapId map = partition.map_of(edge / 3);
    if (!is_boundary(partition.edge_class[edge]))
        return kNone;
    const std::uint32_t beyond = partition.opposite[edge];
    const bool listed_before = beyond != kNone && beyond < edge &&
                               partition.map_of(beyond / 3) == map &&
                               is_boundary(partition.edge_class[beyond]);
    return listed_before ? kNone : map;
}

/// Calls visit(map, segment) for every piece of boundary: edges first, then contacts.
template <typename Visit>
void for_each_segment(const TriangleMesh& mesh, const Partition& partition, const Visit& visit)
{
    const auto edge_count = static_cast<std::uint32_t>(3 * mesh.face_count());
    auto bridged = partition.bridged_edges.begin();
    for (std::uint32_t edge = 0; edge < edge_count; ++edge) {
        if (bridged != partition.bridged_edges.end() && *bridged == edge) {
            ++bridged;
            continue;
        }
        const MapId map = map_bounded_by(partition, edge);
        if (map == kNone)
            continue;
        const glm::uvec3 corners = mesh.corners[edge / 3];
        const int corner = static_cast<int>(edge % 3);
        visit(map, BoundarySegment{mesh.positions[corners[corner]],
                                   mesh.positions[corners[(corner + 1) % 3]]});
    }
    for (const MapContact& contact : partition.contacts)
        visit(contact.map, BoundarySegment{contact.a, contact.b});
}

/// Orders segments by their middle along an axis; only equal segments are equal.
struct ByMiddle {
    int axis;
    auto key(const BoundarySegment& s) const
    {
        return std::tuple(s.a[axis] + s.b[axis], s.a.x, s.a.y, s.a.z, s.b.x, s.b.y, s.b.z);
    }
    bool operator()(const BoundarySegment& l, const BoundarySegment& r) const
    {
        return key(l) < key(r);
    }
};

} // namespace

double distance2_to_box(const glm::vec3& point, const glm::vec3& low, const glm::vec3& high)
{
    const glm::dvec3 p(point);
    const glm::dvec3 off =
        glm::max(glm::max(glm::dvec3(low) - p, p - glm::dvec3(high)), glm::dvec3(0.0));
    return glm::dot(off, off);
}

MapBoundaries::MapBoundaries(const TriangleMesh& mesh, const Partition& partition)
{
    assert(partition.face_count() == mesh.face_count());
    build(partition.map_count, partition.position_error,
          [&](const auto& visit) { for_each_segment(mesh, partition, visit); });
}

MapBoundaries::MapBoundaries(std::span<const MapContact> contacts, float rounding)
{
    const auto for_each = [&](const auto& visit) {
        MapId place = kNone;
        for (std::size_t i = 0; i < contacts.size(); ++i) {
            place += i == 0 || contacts[i].map != contacts[i - 1].map ? 1 : 0;
            visit(place, BoundarySegment{contacts[i].a, contacts[i].b});
        }
    };
    std::size_t count = 0;
    for_each([&](MapId place, const BoundarySegment&) { count = place + std::size_t{1}; });
    build(count, rounding, for_each);
}

template <typename ForEach>
void MapBoundaries::build(std::size_t map_count, float rounding, const ForEach& for_each)
{
    ranges_.resize(map_count + 1);
    std::vector<std::uint32_t> next(map_count + 1, 0);
    for_each([&](MapId map, const BoundarySegment&) { ++next[map]; });
    std::uint32_t total = 0;
    for (std::uint32_t& first : next)
        total += std::exchange(first, total);
    segments_.resize(total);
    for_each([&](MapId map, const BoundarySegment& segment) {
        segments_[next[map]++] = segment; // so that it ends where the next map begins
    });

    std::uint32_t kept = 0;
    for (std::size_t map = 0; map < map_count; ++map) {
        const std::uint32_t from = map == 0 ? 0 : next[map - 1];
        const auto chains =
            join_straight_chains(std::span(segments_).subspan(from, next[map] - from), rounding);
        const std::uint32_t begin = kept;
        for (const BoundarySegment& segment : chains)
            segments_[kept++] = segment;
        ranges_[map] = {begin, kept - begin > kLeafSize ? build_tree(begin, kept) : 0};
    }
    ranges_.back().segment = kept;
    segments_.resize(kept);
    segments_.shrink_to_fit();
    nodes_.shrink_to_fit();
}

OwnBoundaries::OwnBoundaries(const Partition& partition)
    : boundaries(partition.own_contacts, partition.position_error)
{
    for (const MapContact& contact : partition.own_contacts)
        if (maps.empty() || maps.back() != contact.map)
            maps.push_back(contact.map);
}

std::uint32_t MapBoundaries::build_tree(std::uint32_t begin, std::uint32_t end)
{
    Bounds<glm::vec3> box;
    Bounds<glm::vec3> middles;
    for (std::uint32_t i = begin; i < end; ++i) {
        box.add(segments_[i].a);
        box.add(segments_[i].b);
        middles.add(segments_[i].a + segments_[i].b);
    }
    const auto node = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back({box.low, box.high, 0});
    if (end - begin <= kLeafSize)
        return node;

    const std::uint32_t middle = begin + (end - begin) / 2;
    std::nth_element(segments_.begin() + begin, segments_.begin() + middle, segments_.begin() + end,
                     ByMiddle{longest_axis(middles.extent())});
    build_tree(begin, middle);
    const std::uint32_t right = build_tree(middle, end);
    nodes_[node].right = right;
    return node;
}

std::span<const BoundarySegment> MapBoundaries::of(MapId map) const
{
    assert(map + std::size_t{1} < ranges_.size());
    const std::uint32_t begin = ranges_[map].segment;
    return std::span(segments_).subspan(begin, ranges_[map + 1].segment - begin);
}

void MapBoundaries::append_near(std::uint32_t begin, std::uint32_t end, const glm::vec3& point,
                                double radius2, std::vector<BoundarySegment>& out) const
{
    for (std::uint32_t i = begin; i < end; ++i)
        if (distance2_to_segment(point, segments_[i]) <= radius2)
            out.push_back(segments_[i]);
}

bool MapBoundaries::near(MapId map, const glm::vec3& point, float radius,
                         std::vector<BoundarySegment>& out, std::size_t most) const
{
    assert(map + std::size_t{1} < ranges_.size());
    struct Visit {
        std::uint32_t node, begin, end;
    };
    const double radius2 = double(radius) * radius;
    const std::size_t begun = out.size();
    const std::uint32_t first = ranges_[map].segment;
    const std::uint32_t last = ranges_[map + 1].segment;
    if (last - first <= kLeafSize) {
        append_near(first, last, point, radius2, out);
        return out.size() - begun <= most;
    }
    std::array<Visit, 40> stack; // halving 2^32 segments goes 32 deep
    std::size_t depth = 0;
    stack[depth++] = {ranges_[map].node, first, last};
    while (depth > 0 && out.size() - begun <= most) {
        const Visit visit = stack[--depth];
        const Node& node = nodes_[visit.node];
        if (distance2_to_box(point, node.low, node.high) > radius2)
            continue;
        if (visit.end - visit.begin <= kLeafSize) {
            append_near(visit.begin, visit.end, point, radius2, out);
            continue;
        }
        const std::uint32_t middle = visit.begin + (visit.end - visit.begin) / 2;
        stack[depth++] = {node.right, middle, visit.end};
        stack[depth++] = {visit.node + 1, visit.begin, middle};
    }
    return out.size() - begun <= most;
}

} // namespace hipmap
