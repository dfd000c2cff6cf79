#pragma once

#include "tests/support/lit_surface.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace hipmap::tiny {

inline constexpr int kRows = 8, kColumns = 16; ///< bins over the sphere, by polar angle and azimuth
inline constexpr int kInBin = 32;              ///< quadrature points across a bin

inline std::size_t bin_of(const glm::vec3& d)
{
    const float turn = std::atan2(d.y, d.x) / (2 * kPi);
    const int column = static_cast<int>((turn < 0 ? turn + 1 : turn) * kColumns);
    const int row = static_cast<int>(std::acos(std::clamp(d.z, -1.0f, 1.0f)) / kPi * kRows);
    return static_cast<std::size_t>(std::min(row, kRows - 1) * kColumns +
                                    std::min(column, kColumns - 1));
}

/// How far the chi-square statistic of the directions drawn is from its mean, in its standard
/// deviations.  Draws that lead nowhere are a bin of their own.
inline double chi_square_z(const Interaction& at, Lobes lobes)
{
    constexpr std::size_t kBins = kRows * kColumns;
    constexpr int kDraws = 40000;
    std::vector<double> expected(kBins + 1, 0.0), drawn(kBins + 1, 0.0);
    over_sphere(kRows * kInBin, [&](const glm::vec3& in, double solid_angle) {
        expected[bin_of(in)] += double{scattered(at, in, lobes).pdf} * solid_angle * kDraws;
    });
    double sum = 0;
    for (const double one : expected)
        sum += one;
    expected[kBins] = std::max(0.0, kDraws - sum);
    for (std::uint64_t i = 0; i < kDraws; ++i) {
        RandomSequence random(3, RandomStream::pictures, 0, i);
        const ScatterSample sample = sample_scatter(at, lobes, random);
        ++drawn[is_black(sample.weight) ? kBins : bin_of(sample.direction)];
    }
    double square = 0, bins = 0, few_expected = 0, few_drawn = 0;
    for (std::size_t i = 0; i <= kBins; ++i) {
        if (expected[i] < 20) {
            few_expected += expected[i];
            few_drawn += drawn[i];
            continue;
        }
        square += (drawn[i] - expected[i]) * (drawn[i] - expected[i]) / expected[i];
        ++bins;
    }
    if (few_expected > 20) {
        square += (few_drawn - few_expected) * (few_drawn - few_expected) / few_expected;
        ++bins;
    }
    return (square - (bins - 1)) / std::sqrt(2 * (bins - 1));
}

} // namespace hipmap::tiny
