#include "render/photons/path_splitting.h"

#include <cmath>

namespace hipmap {

namespace {

/// Records that tell a deviation; twice as many tell those of two places.
constexpr std::size_t kFewestRecords = 64;

/// Fewer paths gain little, and cost as much each.
constexpr double kFewestSplits = 6;

float deviation_of(std::span<const SplitRecord> records)
{
    double sum = 0, squares = 0;
    for (const SplitRecord& record : records) {
        sum += record.worth;
        squares += double{record.worth} * record.worth;
    }
    const auto count = static_cast<double>(records.size());
    return static_cast<float>(std::sqrt(std::max(0.0, squares - sum * sum / count) / count));
}

} // namespace

PathSplitting learn_splitting(const Partition& partition, std::vector<SplitRecord>& records,
                              double usual)
{
    PathSplitting out;
    if (!(usual > 0))
        return out;
    out.usual = usual;
    out.deviation = learn_placed<float>(
        partition, records, kFewestRecords, deviation_of, [](std::span<const float> side) {
            return std::ranges::any_of(side, [](float deviation) { return deviation > 0; });
        });
    for (const float deviation : out.deviation.values)
        out.most = std::max(out.most, deviation);
    return out;
}

double square_saved(const PathSplitting& splitting, const Partition& partition,
                    std::span<const SplitRecord> records)
{
    double out = 0;
    for (const SplitRecord& record : records) {
        const float* const deviation =
            record.splits > 1 ? value_at(splitting.deviation, partition, record.at) : nullptr;
        if (deviation != nullptr)
            out += std::pow(double{record.power} * *deviation, 2) * (record.splits - 1);
    }
    return out;
}

int splits_at(const PathSplitting& splitting, const Partition& partition, const Place& at,
              double power, int of)
{
    const double by_deviation = power / splitting.usual;
    // Also true of what is not a number.
    if (!(by_deviation * double{splitting.most} > kFewestSplits))
        return 1;
    const float* const deviation = value_at(splitting.deviation, partition, at);
    const double wanted = deviation == nullptr ? 1 : by_deviation * double{*deviation};
    const int most = kMostSplits / of;
    return wanted > kFewestSplits ? static_cast<int>(std::min(std::round(wanted), double(most)))
                                  : 1;
}

} // namespace hipmap
