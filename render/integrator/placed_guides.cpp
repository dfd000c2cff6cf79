#include "render/integrator/placed_guides.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <span>

namespace hipmap {

namespace {

using Shares = DirectionGuide::Shares;

/// Probabilities of drawing from the lobes.
constexpr float kByLobes[] = {0.5f, 0.25f};

/// The records of one side of a map.
using Side = std::span<GatherRecord>;

/// Every how many-th record, from which on.
struct Every {
    std::size_t from = 0;
    std::size_t step = 1;
};

/// Adds what comes from a direction to its cell and those around it, so that few rays fill a
/// window.
void splat(const glm::vec3& direction, float light, Shares& to)
{
    constexpr float kWeights[] = {0.25f, 0.5f, 0.25f};
    constexpr auto kRows = static_cast<int>(DirectionGuide::kRows);
    constexpr auto kColumns = static_cast<int>(DirectionGuide::kColumns);
    const auto cell = static_cast<int>(cell_of(direction));
    const int row = cell / kColumns, column = cell % kColumns;
    for (int v = -1; v <= 1; ++v)
        for (int u = -1; u <= 1; ++u) {
            const int at =
                std::clamp(row + v, 0, kRows - 1) * kColumns + (column + u + kColumns) % kColumns;
            to[static_cast<std::size_t>(at)] += kWeights[v + 1] * kWeights[u + 1] * light;
        }
}

/// The grid that records fill; zero everywhere if they found no light.
Shares grid_of(std::span<const GatherRecord> records, const Every& every)
{
    Shares out{};
    for (std::size_t i = every.from; i < records.size(); i += every.step)
        splat(records[i].direction, records[i].light, out);
    double sum = 0;
    for (const float share : out)
        sum += share;
    for (float& share : out)
        share = sum > 0 ? static_cast<float>(share / sum) : 0.0f;
    return out;
}

DirectionGuide guide_by(const Shares& grid, float by_lobes)
{
    DirectionGuide out{.by_lobes = by_lobes};
    double sum = 0;
    for (std::size_t cell = 0; cell < grid.size(); ++cell)
        out.up_to[cell] = static_cast<float>(sum += grid[cell]);
    out.up_to.back() = 1;
    return out;
}

/// The sum of the squares of what rays of the guide would find, by records that lobes drew.
double sum_of_squares(std::span<const GatherRecord> records, const Every& every,
                      const DirectionGuide& guide)
{
    double out = 0;
    for (std::size_t i = every.from; i < records.size(); i += every.step) {
        const GatherRecord& record = records[i];
        const double ratio = record.pdf / mixed_pdf(guide, record.pdf, record.direction);
        out += double{record.light} * record.light * ratio;
    }
    return out;
}

/// Returns how often directions are to be drawn from the lobes, by records that the grid was not
/// learnt from.
float best_by_lobes(std::span<const GatherRecord> records, double least_gain)
{
    float out = 1;
    const Shares learnt = grid_of(records, {.from = 0, .step = 2});
    const Every test{.from = 1, .step = 2};
    double best = sum_of_squares(records, test, guide_by(learnt, 1)) / least_gain;
    for (const float by_lobes : kByLobes) {
        const double found = sum_of_squares(records, test, guide_by(learnt, by_lobes));
        if (found < best) {
            best = found;
            out = by_lobes;
        }
    }
    return out;
}

DirectionGuide guide_of(std::span<const GatherRecord> records, double least_gain)
{
    return guide_by(grid_of(records, {}), best_by_lobes(records, least_gain));
}

/// The tree of a side of a map, with places of its own.
class TreeBuilder {
  public:
    explicit TreeBuilder(const LearningRule& rule) : rule_(rule) {}

    void build(Side records)
    {
        const std::size_t here = out_.nodes.size();
        out_.nodes.push_back({});
        if (records.size() < 2 * rule_.fewest_rays) {
            out_.nodes[here].next = static_cast<std::uint32_t>(out_.directions.size());
            out_.directions.push_back(guide_of(records, rule_.least_gain));
            return;
        }
        const int axis = longest_axis(records);
        const auto middle = records.begin() + static_cast<std::ptrdiff_t>(records.size() / 2);
        std::nth_element(records.begin(), middle, records.end(),
                         [&](const GatherRecord& a, const GatherRecord& b) {
                             return a.position[axis] < b.position[axis];
                         });
        out_.nodes[here].split = middle->position[axis];
        out_.nodes[here].axis = static_cast<std::uint32_t>(axis);
        build({records.begin(), middle});
        out_.nodes[here].next = static_cast<std::uint32_t>(out_.nodes.size());
        build({middle, records.end()});
    }

    PlacedGuides take() { return std::move(out_); }

  private:
    static int longest_axis(Side records)
    {
        Bounds<glm::vec3> box;
        for (const GatherRecord& record : records)
            box.add(record.position);
        const glm::vec3 extent = box.extent();
        return extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
    }

    const LearningRule& rule_;
    PlacedGuides out_;
};

bool helps(const PlacedGuides& tree)
{
    return std::ranges::any_of(tree.directions,
                               [](const DirectionGuide& guide) { return guide.by_lobes < 1; });
}

/// sides: [trees].
PlacedGuides join(const std::vector<PlacedGuides>& trees, std::span<const std::uint64_t> sides)
{
    PlacedGuides out;
    for (std::size_t i = 0; i < trees.size(); ++i) {
        const PlacedGuides& tree = trees[i];
        if (tree.nodes.empty())
            continue;
        const auto node0 = static_cast<std::uint32_t>(out.nodes.size());
        const auto first = static_cast<std::uint32_t>(out.directions.size());
        out.sides.push_back(sides[i]);
        out.roots.push_back(node0);
        for (PlacedGuides::Node node : tree.nodes) {
            node.next += node.axis == PlacedGuides::kLeaf ? first : node0;
            out.nodes.push_back(node);
        }
        out.directions.insert(out.directions.end(), tree.directions.begin(), tree.directions.end());
    }
    return out;
}

/// Sides of maps that have records.
struct RecordedSides {
    std::vector<std::uint64_t> sides; ///< ascending
    std::vector<std::size_t> ends;    ///< [sides] of their records
};

/// Puts the records of each side of a map behind one another.
RecordedSides sort_by_side(const Partition& partition, std::vector<GatherRecord>& records)
{
    const auto side_of = [&](const GatherRecord& record) {
        return std::uint64_t{2} * partition.map_of(record.face) + record.side;
    };
    std::erase_if(records, [&](const GatherRecord& record) {
        return record.face == kNone || partition.map_of(record.face) == kNone ||
               !(record.pdf > 0) || !std::isfinite(record.light);
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

} // namespace

const DirectionGuide* directions_at(const PlacedGuides& guide, const Partition& partition,
                                    const PhotonQuery& query)
{
    const std::uint32_t map = partition.map_of(query.face);
    if (map == kNone)
        return nullptr;
    const std::uint64_t side = std::uint64_t{2} * map + query.side;
    const auto side_at = std::ranges::lower_bound(guide.sides, side);
    if (side_at == guide.sides.end() || *side_at != side)
        return nullptr;
    std::uint32_t here = guide.roots[static_cast<std::size_t>(side_at - guide.sides.begin())];
    for (;;) {
        const PlacedGuides::Node& node = guide.nodes[here];
        if (node.axis == PlacedGuides::kLeaf) {
            const DirectionGuide& found = guide.directions[node.next];
            return found.by_lobes < 1 ? &found : nullptr;
        }
        here = query.position[static_cast<int>(node.axis)] < node.split ? here + 1 : node.next;
    }
}

PlacedGuides learn_directions(const Partition& partition, std::vector<GatherRecord>& records,
                              const LearningRule& rule)
{
    const auto [sides, all_ends] = sort_by_side(partition, records);
    const std::vector<std::size_t>& ends = all_ends; // lambdas capture no bindings
    std::vector<PlacedGuides> trees(ends.size());
    tbb::parallel_for(std::size_t{0}, ends.size(), [&](std::size_t i) {
        const std::size_t begin = i == 0 ? 0 : ends[i - 1];
        if (ends[i] - begin < rule.fewest_rays)
            return;
        TreeBuilder builder(rule);
        builder.build(Side(records).subspan(begin, ends[i] - begin));
        PlacedGuides tree = builder.take();
        if (helps(tree))
            trees[i] = std::move(tree);
    });
    return join(trees, sides);
}

std::uint64_t checksum(const PlacedGuides& guide)
{
    std::uint64_t sum = 0;
    for (const DirectionGuide& directions : guide.directions) {
        sum = mix_bits(sum + std::bit_cast<std::uint32_t>(directions.by_lobes) + 1);
        for (const float share : directions.up_to)
            sum = mix_bits(sum + std::bit_cast<std::uint32_t>(share) + 1);
    }
    return sum;
}

} // namespace hipmap
