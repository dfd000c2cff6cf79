#pragma once

#include <cmath>

namespace hipmap {

/// Returns the 95 % upper limit of the mean of a Poisson distribution that gave `count`, at least
/// 0.  Source: Wilson and Hilferty 1931.
inline double most_expected(double count)
{
    constexpr double kQuantile = 1.645;
    const double one = count + 1;
    return one * std::pow(1 - 1 / (9 * one) + kQuantile / (3 * std::sqrt(one)), 3);
}

/// Returns the count that a Poisson variable of this mean, at least 0, does not exceed with 95 %.
inline double most_counted(double mean)
{
    constexpr double kMany = 100, kQuantile = 1.645, kInside = 0.95;
    if (mean > kMany)
        return mean + kQuantile * std::sqrt(mean);
    double probability = std::exp(-mean), sum = probability;
    int count = 0;
    while (sum < kInside)
        sum += probability *= mean / ++count;
    return count;
}

} // namespace hipmap
