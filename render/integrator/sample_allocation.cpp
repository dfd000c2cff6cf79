#include "render/integrator/sample_allocation.h"

#include "common/math/random.h"

#include <algorithm>
#include <cmath>

namespace hipmap {

namespace {

/// The least and the most samples of a pixel, relative to the mean; a pilot may miss what is rare
/// and bright.
constexpr double kLeastSamplesShare = 0.25;
constexpr double kMostSamplesShare = 8;

/// A pixel's deviation is taken from those up to so many pixels away: two samples alone say little.
constexpr int kReach = 2;

Rgb finite_or_black(const Rgb& value)
{
    return is_finite(value) ? value : Rgb(0);
}

/// Square of the difference of the images, weighed as in docs/error.md (3), by pixel.
std::vector<double> square_deviations(const Image& first, const Image& second)
{
    std::vector<double> out(first.pixels.size());
    double mean = 0;
    for (std::size_t i = 0; i < out.size(); ++i) {
        const Rgb sum = finite_or_black(first.pixels[i]) + finite_or_black(second.pixels[i]);
        mean += double{sum.x + sum.y + sum.z} / 6 / static_cast<double>(out.size());
    }
    for (std::size_t i = 0; i < out.size(); ++i) {
        const glm::dvec3 a(finite_or_black(first.pixels[i])), b(finite_or_black(second.pixels[i]));
        for (int channel = 0; channel < 3; ++channel) {
            const double value = (a[channel] + b[channel]) / 2;
            const double scale2 = value * value + 0.01 * mean * mean;
            const double difference = a[channel] - b[channel];
            out[i] += scale2 > 0 ? difference * difference / scale2 : 0;
        }
    }
    return out;
}

/// Mean over the pixels around along one axis; `step`: between neighbours, `length`: pixels of it.
void blur(std::vector<double>& values, std::size_t first, std::size_t step, int length)
{
    std::vector<double> sums(static_cast<std::size_t>(length) + 1, 0.0);
    for (int i = 0; i < length; ++i)
        sums[static_cast<std::size_t>(i) + 1] =
            sums[static_cast<std::size_t>(i)] + values[first + static_cast<std::size_t>(i) * step];
    for (int i = 0; i < length; ++i) {
        const int begin = std::max(0, i - kReach), end = std::min(length, i + kReach + 1);
        values[first + static_cast<std::size_t>(i) * step] =
            (sums[static_cast<std::size_t>(end)] - sums[static_cast<std::size_t>(begin)]) /
            (end - begin);
    }
}

/// docs/error.md (14), by pixel of the images.
std::vector<double> deviations_around(const Image& first, const Image& second)
{
    std::vector<double> out = square_deviations(first, second);
    const auto width = static_cast<std::size_t>(first.width);
    for (int y = 0; y < first.height; ++y)
        blur(out, static_cast<std::size_t>(y) * width, 1, first.width);
    for (int x = 0; x < first.width; ++x)
        blur(out, static_cast<std::size_t>(x), width, first.height);
    for (double& deviation : out)
        deviation = std::sqrt(std::max(deviation, 0.0));
    return out;
}

} // namespace

SampleAllocation allocate_samples(const Image& first, const Image& second, int width, int height,
                                  std::uint32_t mean)
{
    const std::vector<double> deviations = deviations_around(first, second);
    const auto deviation_at = [&](int x, int y) {
        const int from_x = x * first.width / width, from_y = y * first.height / height;
        return deviations[static_cast<std::size_t>(from_y) * first.width + from_x];
    };
    double sum = 0;
    for (const double deviation : deviations)
        sum += deviation;
    const double scale = sum > 0 ? mean * static_cast<double>(deviations.size()) / sum : 0;
    SampleAllocation out;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            // Rounded at random, so that the mean stays.
            const double u = static_cast<double>(mix_bits(out.samples.size() + 1) >> 40) * 0x1p-24;
            const double most = std::min(65534.0, kMostSamplesShare * mean);
            const double least = std::max(1.0, kLeastSamplesShare * mean);
            const double wanted = sum > 0 ? std::clamp(scale * deviation_at(x, y), least, most)
                                          : static_cast<double>(mean);
            out.samples.push_back(static_cast<std::uint16_t>(wanted + u));
        }
    return out;
}

std::uint64_t checksum(const SampleAllocation& allocation)
{
    std::uint64_t sum = 0;
    for (const auto* counts : {&allocation.samples, &allocation.lights})
        for (const std::uint16_t samples : *counts)
            sum = mix_bits(sum + samples + 1);
    return sum;
}

} // namespace hipmap
