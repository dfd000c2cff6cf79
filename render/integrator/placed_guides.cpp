#include "render/integrator/placed_guides.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <span>

namespace hipmap {

namespace {

using Shares = DirectionGuide::Shares;

/// Probabilities of drawing from the lobes.
constexpr float kByLobes[] = {0.5f, 0.25f};

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

} // namespace

const DirectionGuide* directions_at(const PlacedGuides& guide, const Partition& partition,
                                    const PhotonQuery& query)
{
    const DirectionGuide* const found =
        value_at(guide, partition, {query.position, query.face, query.side});
    return found != nullptr && found->by_lobes < 1 ? found : nullptr;
}

PlacedGuides learn_directions(const Partition& partition, std::vector<GatherRecord>& records,
                              const LearningRule& rule)
{
    std::erase_if(records, [](const GatherRecord& record) {
        return !(record.pdf > 0) || !std::isfinite(record.light);
    });
    return {learn_placed<DirectionGuide>(
        partition, records, rule.fewest_rays,
        [&](std::span<const GatherRecord> leaf) { return guide_of(leaf, rule.least_gain); },
        [](std::span<const DirectionGuide> side) {
            return std::ranges::any_of(
                side, [](const DirectionGuide& guide) { return guide.by_lobes < 1; });
        })};
}

std::uint64_t checksum(const PlacedGuides& guide)
{
    std::uint64_t sum = 0;
    for (const DirectionGuide& directions : guide.values) {
        sum = mix_bits(sum + std::bit_cast<std::uint32_t>(directions.by_lobes) + 1);
        for (const float share : directions.up_to)
            sum = mix_bits(sum + std::bit_cast<std::uint32_t>(share) + 1);
    }
    return sum;
}

} // namespace hipmap
