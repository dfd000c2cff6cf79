#include "render/maps/fold_tree.h"

#include "common/math/bounds.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <array>
#include <utility>

namespace hipmap {

namespace {

struct FaceSums {
    struct Facing {
        double area = 0;
        glm::dvec3 vector{0.0};
    };

    Bounds<glm::vec3> box;
    double area = 0;
    glm::dvec3 middle{0.0};
    glm::dvec3 variance{0.0}, covariance{0.0}; ///< as FoldNode's, times the area
    std::array<Facing, FoldNode::kDirections> along;

    void add(const FaceSums& other)
    {
        box.add(other.box.low);
        box.add(other.box.high);
        for (std::size_t i = 0; i < along.size(); ++i) {
            along[i].area += other.along[i].area;
            along[i].vector += other.along[i].vector;
        }
        if (!(other.area > 0))
            return;
        const double both = area + other.area;
        const glm::dvec3 apart = other.middle - middle;
        add_spread(apart, area * other.area / both);
        variance += other.variance;
        covariance += other.covariance;
        middle += apart * (other.area / both);
        area = both;
    }

    void add_spread(const glm::dvec3& apart, double weight)
    {
        variance += weight * apart * apart;
        covariance +=
            weight * glm::dvec3(apart.y, apart.z, apart.x) * glm::dvec3(apart.z, apart.x, apart.y);
    }
};

struct Item {
    glm::vec3 place; ///< three times the middle
    FaceId face;
};

void halve(std::span<Item> items, std::size_t middle)
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

/// Sorts faces so that each aligned range of 8, 64, 512, ... lies together.
void sort_by_place(std::span<Item> items)
{
    constexpr std::size_t kAlone = 4096;
    if (items.size() <= kFoldWidth)
        return;
    std::size_t unit = kFoldWidth;
    while (unit * kFoldWidth < items.size())
        unit *= kFoldWidth;
    const std::size_t units = (items.size() + unit - 1) / unit, middle = (units + 1) / 2 * unit;
    halve(items, middle);
    const auto left = [=] { sort_by_place(items.first(middle)); };
    const auto right = [=] { sort_by_place(items.subspan(middle)); };
    if (items.size() > kAlone)
        return tbb::parallel_invoke(left, right);
    left();
    right();
}

std::uint32_t blocks_of(std::size_t items)
{
    return static_cast<std::uint32_t>((items + kFoldWidth - 1) / kFoldWidth);
}

std::uint32_t nodes_of(std::size_t faces)
{
    std::uint32_t out = 0;
    for (std::uint32_t level = blocks_of(faces); level > 1; out += level)
        level = blocks_of(level);
    return out;
}

void write_lane(const glm::dvec3& values, float (&out)[3][kFoldWidth], std::size_t lane)
{
    for (int axis = 0; axis < 3; ++axis)
        out[axis][lane] = static_cast<float>(values[axis]);
}

/// Writes one child of a node.
void write_child(const FaceSums& sums, FoldNode& node, std::size_t lane)
{
    write_lane(sums.box.low, node.low, lane);
    write_lane(sums.box.high, node.high, lane);
    if (!(sums.area > 0))
        return;
    write_lane(sums.middle, node.middle, lane);
    write_lane(sums.variance / sums.area, node.variance, lane);
    write_lane(sums.covariance / sums.area, node.covariance, lane);
    for (std::size_t i = 0; i < FoldNode::kDirections; ++i)
        if (const auto& [area, vector] = sums.along[i]; area > 0) {
            node.area[i][lane] = static_cast<float>(area);
            write_lane(vector / area, node.normal[i], lane);
        }
}

class TreeBuilder {
  public:
    TreeBuilder(const TriangleMesh& mesh, const Partition& partition, FoldTrees& out)
        : mesh_(mesh), partition_(partition), out_(out)
    {
    }

    /// Writes a tree over faces (not empty), and returns its root.
    FoldPlace build(std::span<const FaceId> faces, std::uint32_t first_block,
                    std::uint32_t first_node)
    {
        std::vector<Item> items;
        items.reserve(faces.size());
        for (const FaceId face : faces) {
            const auto [a, b, c] = mesh_.triangle(face);
            items.push_back({a + b + c, face});
        }
        sort_by_place(items);
        std::vector<FaceSums> sums(blocks_of(items.size()));
        tbb::parallel_for(std::size_t{0}, sums.size(), [&](std::size_t i) {
            const std::span rest = std::span(items).subspan(i * kFoldWidth);
            sums[i] = write_block(rest.first(std::min<std::size_t>(kFoldWidth, rest.size())),
                                  out_.blocks[first_block + i]);
        });
        FoldPlace first{first_block, true};
        for (std::uint32_t next = first_node; sums.size() > 1;) {
            sums = write_level(sums, next, first);
            first = {next, false};
            next += static_cast<std::uint32_t>(sums.size());
        }
        return first;
    }

  private:
    FaceSums write_block(std::span<const Item> items, FoldBlock& block) const
    {
        FaceSums out;
        for (std::size_t lane = 0; lane < kFoldWidth; ++lane) {
            const bool held = lane < items.size();
            const FaceId face = items[held ? lane : 0].face;
            auto corners = mesh_.triangle(face);
            if (partition_.is_flipped(face))
                std::swap(corners[1], corners[2]);
            for (std::size_t i = 0; i < 3; ++i)
                write_lane(corners[held ? i : 0], block.corner[i], lane);
            if (held)
                out.add(sums_of(face));
        }
        return out;
    }

    FaceSums sums_of(FaceId face) const
    {
        FaceSums out;
        const glm::dvec3 vector =
            scaled_normal(mesh_, face) * (partition_.is_flipped(face) ? -0.5 : 0.5);
        const auto corners = mesh_.triangle(face);
        out.area = glm::length(vector);
        for (const glm::vec3& corner : corners) {
            out.box.add(corner);
            out.middle += glm::dvec3(corner) / 3.0;
        }
        for (const glm::vec3& corner : corners)
            out.add_spread(glm::dvec3(corner) - out.middle, out.area / 12);
        const int axis = longest_axis(glm::abs(glm::vec3(vector)));
        out.along[static_cast<std::size_t>(2 * axis + (vector[axis] < 0 ? 1 : 0))] = {out.area,
                                                                                      vector};
        return out;
    }

    /// Writes the nodes over a level from `next` on, and returns their sums.
    std::vector<FaceSums> write_level(const std::vector<FaceSums>& below, std::uint32_t next,
                                      const FoldPlace& first) const
    {
        std::vector<FaceSums> out(blocks_of(below.size()));
        tbb::parallel_for(std::size_t{0}, out.size(), [&](std::size_t i) {
            FoldNode& node = out_.nodes[next + i];
            node.first_child = first.number + static_cast<std::uint32_t>(i) * kFoldWidth;
            node.of_blocks = first.is_block;
            for (std::size_t lane = 0; lane < kFoldWidth; ++lane) {
                const std::size_t child = i * kFoldWidth + lane;
                write_child(child < below.size() ? below[child] : FaceSums(), node, lane);
                if (child < below.size())
                    out[i].add(below[child]);
            }
        });
        return out;
    }

    const TriangleMesh& mesh_;
    const Partition& partition_;
    FoldTrees& out_;
};

} // namespace

FoldTrees build_fold_trees(const TriangleMesh& mesh, const Partition& partition,
                           std::span<const std::uint32_t> fold_of)
{
    const auto folds = std::ranges::count_if(fold_of, [](auto fold) { return fold != kNone; });
    std::vector<std::vector<FaceId>> faces(static_cast<std::size_t>(folds));
    for (FaceId face = 0; face < mesh.face_count(); ++face)
        if (const MapId map = partition.map_of(face); map != kNone && fold_of[map] != kNone)
            faces[fold_of[map]].push_back(face);

    FoldTrees out;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> first;
    std::uint32_t blocks = 0, nodes = 0;
    for (const std::vector<FaceId>& tree : faces) {
        first.emplace_back(blocks, nodes);
        blocks += blocks_of(tree.size());
        nodes += nodes_of(tree.size());
    }
    out.blocks.resize(blocks);
    out.nodes.resize(nodes);
    out.roots.resize(faces.size());
    tbb::parallel_for(std::size_t{0}, faces.size(), [&](std::size_t i) {
        out.roots[i] =
            TreeBuilder(mesh, partition, out).build(faces[i], first[i].first, first[i].second);
    });
    return out;
}

} // namespace hipmap
