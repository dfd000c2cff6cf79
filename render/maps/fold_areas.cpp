#include "render/maps/fold_areas.h"

#include "common/math/bounds.h"
#include "render/maps/triangle_around.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace hipmap {

namespace {

/// What is narrower than this part of the least radius counts by the distance of its middle.
constexpr float kSmall = 0.5f;
/// Nodes whose cosines spread less than this count by their mean.
constexpr double kNarrow = 0.5;

/// Half the cross product of two edges of a face, towards its side 0.
glm::dvec3 area_vector(const TriangleMesh& mesh, const Partition& partition, FaceId face)
{
    return scaled_normal(mesh, face) * (partition.is_flipped(face) ? -0.5 : 0.5);
}

struct FaceSums {
    Bounds<glm::vec3> box;
    double area = 0;
    glm::dvec3 vector{0.0};
    glm::dvec3 moment{0.0}; ///< area times place

    void add(const FaceSums& other)
    {
        box.add(other.box.low);
        box.add(other.box.high);
        area += other.area;
        vector += other.vector;
        moment += other.moment;
    }
};

FoldAreas::Node node_of(const FaceSums& sums)
{
    FoldAreas::Node out{sums.box.low,
                        sums.box.high,
                        sums.box.centre(),
                        static_cast<float>(sums.area),
                        glm::vec3(0),
                        0,
                        1,
                        0};
    const double length = glm::length(sums.vector);
    if (!(length > 0))
        return out;
    const double alike = length / sums.area;
    const double cap = std::clamp(2 * alike - 1, 0.0, 1.0);
    out.middle = glm::vec3(sums.moment / sums.area);
    out.normal = glm::vec3(sums.vector / length);
    out.alike = static_cast<float>(alike);
    out.spread = static_cast<float>(std::sqrt(1 - cap * cap));
    return out;
}

/// Returns the number of nodes of a tree.
std::uint32_t nodes_for(std::uint32_t faces)
{
    return faces <= FoldAreas::kLeafSize ? 1
                                         : 1 + nodes_for(faces / 2) + nodes_for(faces - faces / 2);
}

/// Builds one tree.
class TreeBuilder {
  public:
    /// nodes: of all trees; next: where those of this one begin.
    TreeBuilder(const TriangleMesh& mesh, const Partition& partition,
                std::span<FoldAreas::Node> nodes, std::uint32_t next)
        : mesh_(mesh), partition_(partition), nodes_(nodes), next_(next)
    {
    }

    /// Orders the faces and writes their nodes.
    void build(std::span<FaceId> faces)
    {
        std::vector<Item> items;
        items.reserve(faces.size());
        for (const FaceId face : faces) {
            const auto [a, b, c] = mesh_.triangle(face);
            items.push_back({a + b + c, face});
        }
        add(items);
        std::ranges::transform(items, faces.begin(), &Item::face);
    }

  private:
    struct Item {
        glm::vec3 place; ///< three times the middle
        FaceId face;
    };

    FaceSums add(std::span<Item> items)
    {
        const std::uint32_t node = next_++;
        FaceSums sums;
        std::uint32_t right = 0;
        if (items.size() <= FoldAreas::kLeafSize)
            for (const Item& item : items)
                sums.add(sums_of(item.face));
        else {
            const std::size_t middle = items.size() / 2;
            halve(items, middle);
            sums = add(items.first(middle));
            right = next_;
            sums.add(add(items.subspan(middle)));
        }
        nodes_[node] = node_of(sums);
        nodes_[node].right = right;
        return sums;
    }

    static void halve(std::span<Item> items, std::size_t middle)
    {
        Bounds<glm::vec3> places;
        for (const Item& item : items)
            places.add(item.place);
        const int axis = longest_axis(places.extent());
        std::ranges::nth_element(items, items.begin() + static_cast<std::ptrdiff_t>(middle),
                                 [axis](const Item& l, const Item& r) {
                                     return std::pair(l.place[axis], l.face) <
                                            std::pair(r.place[axis], r.face);
                                 });
    }

    FaceSums sums_of(FaceId face) const
    {
        FaceSums out;
        out.vector = area_vector(mesh_, partition_, face);
        out.area = glm::length(out.vector);
        for (const glm::vec3& corner : mesh_.triangle(face)) {
            out.box.add(corner);
            out.moment += out.area / 3 * glm::dvec3(corner);
        }
        return out;
    }

    const TriangleMesh& mesh_;
    const Partition& partition_;
    std::span<FoldAreas::Node> nodes_;
    std::uint32_t next_;
};

} // namespace

FoldAreas::FoldAreas(const TriangleMesh& mesh, const Partition& partition,
                     std::span<const std::uint32_t> fold_of)
    : mesh_(mesh), partition_(partition)
{
    const auto folds = std::ranges::count_if(fold_of, [](auto fold) { return fold != kNone; });
    trees_.resize(kTreesOfFold * static_cast<std::size_t>(folds));
    const auto for_each_face = [&](const auto& use) {
        for (FaceId face = 0; face < mesh.face_count(); ++face) {
            const MapId map = partition.map_of(face);
            if (map == kNone || fold_of[map] == kNone)
                continue;
            const glm::vec3 along(area_vector(mesh, partition, face));
            const int axis = longest_axis(glm::abs(along));
            use(face, trees_[kTreesOfFold * fold_of[map] + 2 * axis + (along[axis] < 0 ? 1 : 0)]);
        }
    };
    for_each_face([](FaceId, Tree& tree) { ++tree.end; });
    std::uint32_t faces = 0, nodes = 0;
    for (Tree& tree : trees_) {
        tree.begin = faces;
        tree.root = nodes;
        nodes += tree.end > 0 ? nodes_for(tree.end) : 0;
        faces += std::exchange(tree.end, faces);
    }
    faces_.resize(faces);
    nodes_.resize(nodes);
    for_each_face([&](FaceId face, Tree& tree) { faces_[tree.end++] = face; });

    tbb::parallel_for(std::size_t{0}, trees_.size(), [&](std::size_t i) {
        const auto [begin, end, root] = trees_[i];
        if (begin < end)
            TreeBuilder(mesh, partition, nodes_, root).build({&faces_[begin], end - begin});
    });
}

namespace {

/// The cosines between the normals of a node's faces and a query's, taken to be spread evenly from
/// the lowest to the highest: those of a cap of directions about their mean, docs/visible_area.md
/// (A9).
struct Slopes {
    double mean, lowest, highest;

    Slopes(const FoldAreas::Node& node, const glm::dvec3& normal)
    {
        const double along = glm::dot(glm::dvec3(node.normal), normal);
        mean = along * node.alike;
        lowest = along - node.spread;
        highest = along + node.spread;
    }

    /// Returns the part of the area that looks to the query's side, of the `near` part that lies
    /// nearest to it: what looks to its side is nearer than what does not.
    double part(AreaOf of, double near) const
    {
        if (highest <= 0)
            return 0;
        const double facing = lowest >= 0 ? 1 : highest / (highest - lowest);
        const double both = std::min(near, facing);
        if (of == AreaOf::surface)
            return both;
        return both * (lowest >= 0 ? mean : highest - both * (highest - lowest) / 2);
    }
};

/// The distances of something from a query.
struct Distances {
    double nearest, farthest, middle;

    /// Returns the part of its area that lies within a radius.
    double part_within(double radius) const
    {
        if (radius >= farthest)
            return 1;
        if (radius <= nearest)
            return 0;
        const double half = std::max(middle - nearest, farthest - middle);
        return std::clamp(0.5 + (radius - middle) / (2 * half), 0.0, 1.0);
    }
};

} // namespace

/// Walks trees from their largest nodes to the smallest, so that what is left over when it has
/// opened enough of them is small.
class FoldWalk {
  public:
    FoldWalk(const FoldAreas& areas, const FoldQuery& query, std::span<const float> radii)
        : areas_(areas), query_(query), radii_(radii)
    {
        const auto [least, most] = std::ranges::minmax(radii);
        small_ = kSmall * least;
        widest2_ = double{most} * most;
    }

    FoldAreas::Areas sum()
    {
        const std::size_t first = FoldAreas::kTreesOfFold * std::size_t{query_.fold};
        for (const FoldAreas::Tree& tree :
             std::span(areas_.trees_).subspan(first, FoldAreas::kTreesOfFold))
            if (tree.begin < tree.end)
                push(tree.root, tree.begin, tree.end);
        for (std::size_t i = 0; i < waiting_; ++i)
            visit(queue_[i], i >= FoldAreas::kMostOpen);
        return sums_;
    }

  private:
    struct Entry {
        std::uint32_t node, begin, end;
    };

    void push(std::uint32_t node, std::uint32_t begin, std::uint32_t end)
    {
        queue_[waiting_++] = {node, begin, end};
    }

    void visit(const Entry& entry, bool enough)
    {
        const FoldAreas::Node& node = areas_.nodes_[entry.node];
        const glm::dvec3 low = glm::dvec3(node.low) - query_.point;
        const glm::dvec3 high = glm::dvec3(node.high) - query_.point;
        const glm::dvec3 outside = glm::max(glm::max(low, -high), glm::dvec3(0));
        const double near2 = glm::dot(outside, outside);
        if (near2 >= widest2_)
            return;
        const Slopes slopes(node, query_.normal);
        if (slopes.highest <= 0)
            return;
        const glm::dvec3 corner = glm::max(-low, high);
        const double far2 = glm::dot(corner, corner);
        const bool cut = std::ranges::any_of(
            radii_, [&](float r) { return near2 < double{r} * r && double{r} * r < far2; });
        const glm::vec3 extent = node.high - node.low;
        const bool small = std::max({extent.x, extent.y, extent.z}) < small_;
        const bool settled = slopes.lowest >= 0 || slopes.highest - slopes.lowest < kNarrow;
        if (enough || (settled && (small || !cut))) {
            const Distances at{std::sqrt(near2), std::sqrt(far2),
                               glm::distance(glm::dvec3(node.middle), query_.point)};
            for (std::size_t r = 0; r < radii_.size(); ++r)
                sums_[r] += node.area * slopes.part(query_.of, at.part_within(radii_[r]));
            return;
        }
        if (entry.end - entry.begin <= FoldAreas::kLeafSize) {
            for (std::uint32_t i = entry.begin; i < entry.end; ++i)
                add_face(areas_.faces_[i]);
            return;
        }
        const std::uint32_t middle = entry.begin + (entry.end - entry.begin) / 2;
        push(entry.node + 1, entry.begin, middle);
        push(node.right, middle, entry.end);
    }

    void add_face(FaceId face)
    {
        const TriangleAround triangle(areas_.mesh_.triangle(face), query_.point);
        if (triangle.nearest2() >= widest2_)
            return;
        const double sign = areas_.partition_.is_flipped(face) ? -1 : 1;
        const double along = sign * glm::dot(triangle.vector(), query_.normal);
        if (!(along > 0))
            return;
        const double area = glm::length(triangle.vector());
        const double part = query_.of == AreaOf::projection ? along / area : 1;
        if (triangle.extent() >= small_)
            return triangle.add_within(radii_, part, sums_);
        const Distances at{std::sqrt(triangle.nearest2()), std::sqrt(triangle.farthest2()),
                           glm::length(triangle.middle())};
        for (std::size_t r = 0; r < radii_.size(); ++r)
            sums_[r] += part * area * at.part_within(radii_[r]);
    }

    const FoldAreas& areas_;
    const FoldQuery& query_;
    std::span<const float> radii_;
    float small_ = 0;
    double widest2_ = 0;
    std::array<Entry, FoldAreas::kTreesOfFold + 2 * FoldAreas::kMostOpen> queue_;
    std::size_t waiting_ = 0;
    FoldAreas::Areas sums_{};
};

FoldAreas::Areas FoldAreas::within(const FoldQuery& query, std::span<const float> radii) const
{
    return FoldWalk(*this, query, radii).sum();
}

} // namespace hipmap
