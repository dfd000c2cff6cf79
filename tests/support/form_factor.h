#pragma once

#include <cmath>

namespace hipmap {

/// Irradiance under a parallel rectangle of radiance 1 at height h whose corner lies straight above
/// the point; sides a, b.  Source: the configuration factor of Howell's catalogue, C-11, times pi.
inline double corner_rectangle(double a, double b, double h)
{
    const double p = a / h, q = b / h;
    const double u = std::sqrt(1 + p * p), v = std::sqrt(1 + q * q);
    return 0.5 * (p / u * std::atan(q / u) + q / v * std::atan(p / v));
}

} // namespace hipmap
