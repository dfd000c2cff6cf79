#include "render/film/expected_light.h"

#include "common/math/poisson.h"

#include <algorithm>
#include <cmath>

namespace hipmap {

namespace {

/// The exponents of the most frequent and of the rarest light.
constexpr int kMost = 3, kLeast = kMost - ExpectedLight::kOctaves;

} // namespace

void add_light(const RareLight& light, ExpectedLight& into)
{
    const bool counts = light.variance > 0 && light.finds > 0 && std::isfinite(light.variance) &&
                        std::isfinite(light.missing);
    if (!counts || std::ilogb(light.finds) >= kMost)
        return;
    const int octave = std::max(std::ilogb(light.finds), kLeast) - kLeast;
    RareLight& sum = into.light[static_cast<std::size_t>(octave)];
    sum.variance += light.variance;
    sum.missing += light.missing;
    sum.finds += light.finds;
}

double missing_square(const ExpectedLight& expected, std::uint64_t passes)
{
    const auto n = static_cast<double>(passes);
    RareLight sum;
    for (int octave = 0; octave < ExpectedLight::kOctaves; ++octave) {
        const RareLight& light = expected.light[static_cast<std::size_t>(octave)];
        const double finds = n * std::ldexp(std::sqrt(2.0), octave + kLeast); // amid the octave
        // The share of the pixels that may not have found it: their samples are stratified.
        const double missed = std::exp(-finds * finds / 2);
        sum.variance += missed * light.variance / n;
        sum.missing += missed * light.missing;
        sum.finds += missed * light.finds * n;
    }
    const double found = sum.finds > 0 ? most_counted(sum.finds) / sum.finds : 0;
    return sum.missing + found * sum.variance;
}

} // namespace hipmap
