#include "render/film/expected_light.h"

#include "common/math/poisson.h"

#include <algorithm>
#include <cmath>

namespace hipmap {

namespace {

/// The exponents of the most frequent and of the rarest light.
constexpr int kMost = 3, kLeast = kMost - ExpectedLight::kOctaves;

/// Returns the share of the pixels with the light of an octave that so many passes may not have
/// found it in: their samples are stratified.
double share_missed(int octave, double passes)
{
    const double finds = passes * std::ldexp(std::sqrt(2.0), octave + kLeast); // amid the octave
    return std::exp(-finds * finds / 2);
}

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
        const double missed = share_missed(octave, n);
        sum.variance += missed * light.variance / n;
        sum.missing += missed * light.missing;
        sum.finds += missed * light.finds * n;
    }
    const double found = sum.finds > 0 ? most_counted(sum.finds) / sum.finds : 0;
    return sum.missing + found * sum.variance;
}

double unmet_square(const ExpectedLight& expected, double passes, double later)
{
    double out = 0;
    for (int octave = 0; octave < ExpectedLight::kOctaves; ++octave) {
        const RareLight& light = expected.light[static_cast<std::size_t>(octave)];
        const double finds = later * light.finds;
        const double twice = 1 - std::exp(-finds) * (1 + finds); // the probability
        out += share_missed(octave, passes) * twice * light.variance / later;
    }
    return out;
}

} // namespace hipmap
