#include "render/lobes/fresnel.h"

#include <cmath>

namespace hipmap {

float average_dielectric_weight(float index)
{
    constexpr double kSame = 1e-4; // nearer to 1 the terms cancel to less than their rounding
    const double n = index, n2 = n * n, n4 = n2 * n2;
    if (!(n - 1 > kSame))
        return 0;
    const double average =
        0.5 + (n - 1) * (3 * n + 1) / (6 * (n + 1) * (n + 1)) +
        n2 * (n2 - 1) * (n2 - 1) / std::pow(n2 + 1, 3) * std::log((n - 1) / (n + 1)) -
        2 * n2 * n * (n2 + 2 * n - 1) / ((n2 + 1) * (n4 - 1)) +
        8 * n4 * (n4 + 1) / ((n2 + 1) * (n4 - 1) * (n4 - 1)) * std::log(n);
    const double least = reflectance_of_index(index);
    return static_cast<float>((average - least) / (1 - least));
}

Rgb scaled_fresnel(float cosine, float eta, const Rgb& scale)
{
    const float f = fresnel_dielectric(cosine, eta);
    return f < 1 ? f * scale : Rgb(1);
}

} // namespace hipmap
