#pragma once

#include <algorithm>
#include <cmath>

namespace hipmap {

/// Returns glTF's roughness for a Phong exponent: the microfacet width sqrt(2 / (Ns + 2)) (Walter
/// et al. 2007) is the square of it.  An exponent below 0 counts as 0.
inline float roughness_of_exponent(double exponent)
{
    return static_cast<float>(std::pow(2.0 / (std::max(0.0, exponent) + 2.0), 0.25));
}

} // namespace hipmap
