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

} // namespace hipmap
