#pragma once

#include "common/math/bounds.h"
#include "common/partition/partition.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace hipmap {

/// A node of the tree over the places of one side of a map; its lower child comes next.
struct PlaceNode {
    static constexpr std::uint32_t kLeaf = 3; ///< as an axis

    float split = 0;
    std::uint32_t axis = kLeaf; ///< coordinate that is split; kLeaf: none
    std::uint32_t next = 0;     ///< upper child; of a leaf its place in Placed::values
};

/// What was learnt from records, by place on each side of the shared maps.
template <typename Value>
struct Placed {
    std::vector<std::uint64_t> sides; ///< ascending; 2 * shared map + side of those with values
    std::vector<std::uint32_t> roots; ///< [sides] in `nodes`
    std::vector<PlaceNode> nodes;
    std::vector<Value> values;
};

/// A place on a side of a face, scene units.
struct Place {
    glm::vec3 position{0.0f};
    FaceId face = kNone;
    std::uint8_t side = 0; ///< 0 or 1, see Interaction
};

/// Returns the value at a place.  Null: there is none.  Thread-safe.
template <typename Value>
const Value* value_at(const Placed<Value>& placed, const Partition& partition, const Place& at)
{
    const MapId map = partition.map_of(at.face);
    if (map == kNone)
        return nullptr;
    const std::uint64_t side = std::uint64_t{2} * map + at.side;
    const auto found = std::ranges::lower_bound(placed.sides, side);
    if (found == placed.sides.end() || *found != side)
        return nullptr;
    std::uint32_t here = placed.roots[static_cast<std::size_t>(found - placed.sides.begin())];
    for (;;) {
        const PlaceNode& node = placed.nodes[here];
        if (node.axis == PlaceNode::kLeaf)
            return &placed.values[node.next];
        here = at.position[static_cast<int>(node.axis)] < node.split ? here + 1 : node.next;
    }
}

namespace placed_detail {

/// Builds the tree of a side of a map, with values of its own.  Record: with a Place `at`.
template <typename Value, typename Record, typename MakeValue>
class TreeBuilder {
  public:
    TreeBuilder(std::size_t fewest, const MakeValue& make) : fewest_(fewest), make_(make) {}

    void build(std::span<Record> records)
    {
        const std::size_t here = out_.nodes.size();
        out_.nodes.push_back({});
        if (records.size() < 2 * fewest_) {
            out_.nodes[here].next = static_cast<std::uint32_t>(out_.values.size());
            out_.values.push_back(make_(std::span<const Record>(records)));
            return;
        }
        Bounds<glm::vec3> box;
        for (const Record& record : records)
            box.add(record.at.position);
        const int axis = longest_axis(box.extent());
        const auto middle = records.begin() + static_cast<std::ptrdiff_t>(records.size() / 2);
        std::nth_element(records.begin(), middle, records.end(),
                         [&](const Record& a, const Record& b) {
                             return a.at.position[axis] < b.at.position[axis];
                         });
        out_.nodes[here].split = middle->at.position[axis];
        out_.nodes[here].axis = static_cast<std::uint32_t>(axis);
        build({records.begin(), middle});
        out_.nodes[here].next = static_cast<std::uint32_t>(out_.nodes.size());
        build({middle, records.end()});
    }

    Placed<Value> take() { return std::move(out_); }

  private:
    const std::size_t fewest_;
    const MakeValue& make_;
    Placed<Value> out_;
};

/// Adds the tree of a side of a map.
template <typename Value>
void add_side(std::uint64_t side, const Placed<Value>& tree, Placed<Value>& out)
{
    const auto node0 = static_cast<std::uint32_t>(out.nodes.size());
    const auto first = static_cast<std::uint32_t>(out.values.size());
    out.sides.push_back(side);
    out.roots.push_back(node0);
    for (PlaceNode node : tree.nodes) {
        node.next += node.axis == PlaceNode::kLeaf ? first : node0;
        out.nodes.push_back(node);
    }
    out.values.insert(out.values.end(), tree.values.begin(), tree.values.end());
}

/// Sides of maps that have records.
struct RecordedSides {
    std::vector<std::uint64_t> sides; ///< ascending
    std::vector<std::size_t> ends;    ///< [sides] of their records
};

/// Puts the records of each side of a map behind one another, and drops those without a map.
template <typename Record>
RecordedSides sort_by_side(const Partition& partition, std::vector<Record>& records)
{
    const auto side_of = [&](const Record& record) {
        return std::uint64_t{2} * partition.map_of(record.at.face) + record.at.side;
    };
    std::erase_if(records, [&](const Record& record) {
        return record.at.face == kNone || partition.map_of(record.at.face) == kNone;
    });
    std::ranges::stable_sort(records, {}, side_of);
    RecordedSides out;
    for (std::size_t i = 0; i < records.size(); ++i) {
        if (const std::uint64_t side = side_of(records[i]);
            out.sides.empty() || out.sides.back() != side) {
            out.sides.push_back(side);
            out.ends.push_back(i);
        }
        ++out.ends.back();
    }
    return out;
}

} // namespace placed_detail

/// Learns values from records, which move within their vector and have a Place `at`.  A tree for
/// each side of a map divides its records at the median, along the longest axis of their box, down
/// to leaves of at least `fewest`.  A side that has fewer has no values, and neither has one for
/// which helps(its values) is false.
/// make(records of a leaf): its value.  In parallel; the result is the same at any thread count.
template <typename Value, typename Record, typename MakeValue, typename Helps>
Placed<Value> learn_placed(const Partition& partition, std::vector<Record>& records,
                           std::size_t fewest, const MakeValue& make, const Helps& helps)
{
    const placed_detail::RecordedSides found = placed_detail::sort_by_side(partition, records);
    std::vector<Placed<Value>> trees(found.ends.size());
    tbb::parallel_for(std::size_t{0}, trees.size(), [&](std::size_t i) {
        const std::size_t begin = i == 0 ? 0 : found.ends[i - 1];
        const std::size_t size = found.ends[i] - begin;
        if (size < fewest)
            return;
        placed_detail::TreeBuilder<Value, Record, MakeValue> builder(fewest, make);
        builder.build(std::span(records).subspan(begin, size));
        trees[i] = builder.take();
    });
    Placed<Value> out;
    for (std::size_t i = 0; i < trees.size(); ++i)
        if (!trees[i].values.empty() && helps(std::span<const Value>(trees[i].values)))
            placed_detail::add_side(found.sides[i], trees[i], out);
    return out;
}

} // namespace hipmap
