#include "render/integrator/sample_allocation.h"

#include "common/math/random.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace hipmap {

namespace {

/// The least and the most samples of a pixel, relative to the mean; a pilot may miss what is rare
/// and bright.
constexpr double kLeastSamplesShare = 0.25;
constexpr double kMostSamplesShare = 8;
constexpr double kMostLightSamplesShare = 64;

/// The cost of a sample of the seen lights over that of another: at least, and by surface it meets.
constexpr double kLeastLightCost = 1.0 / 9, kLightCostBySurface = 0.1;

/// A pixel's deviation is taken from those up to so many pixels away: two samples alone say little.
constexpr int kReach = 2;

/// All 25 pairs of samples within that reach may miss what is rare, which pixels farther away meet.
/// So this share of the variance comes from a wider window.
constexpr int kWideReach = 12;
constexpr double kWideShare = 0.1;

/// Squares of differences of two samples of each pixel, weighed as in docs/error.md (3).
std::vector<double> square_deviations(const PilotBrightness& brightness, const Image& differences)
{
    std::vector<double> out(brightness.mean.size());
    for (std::size_t i = 0; i < out.size(); ++i)
        for (int channel = 0; channel < 3; ++channel) {
            const double value = brightness.mean[i][channel];
            const double scale2 = value * value + brightness.least2;
            const double difference = finite_or_black(differences.pixels[i])[channel];
            out[i] += scale2 > 0 ? difference * difference / scale2 : 0;
        }
    return out;
}

/// A difference of two samples has twice the variance of one, and there are three channels.
constexpr double kShareOfSquare = 1.0 / 6;

/// docs/error.md (14), by pixel of the pilot's images: the variance of a sample, over the square of
/// brightness.  differences: of two samples.
std::vector<double> variances_around(const PilotBrightness& brightness, const Image& differences)
{
    std::vector<double> out = square_deviations(brightness, differences);
    const std::vector<double> wide = blurred(out, differences.width, kWideReach);
    out = blurred(std::move(out), differences.width, kReach);
    for (std::size_t i = 0; i < out.size(); ++i)
        out[i] = kShareOfSquare * std::max((1 - kWideShare) * out[i] + kWideShare * wide[i], 0.0);
    return out;
}

Image difference_of(const Image& first, const Image& second)
{
    Image out = first;
    for (std::size_t i = 0; i < out.pixels.size(); ++i)
        out.pixels[i] = finite_or_black(first.pixels[i]) - finite_or_black(second.pixels[i]);
    return out;
}

/// docs/error.md (26).  variances: by pixel of the pilot's images.
int choose_emissive_points(const PilotNoise& pilot, const PilotBrightness& brightness,
                           const std::vector<double>& variances)
{
    constexpr double kCost = 0.05; // of a further point, over that of a sample with one
    if (pilot.emissive == nullptr || pilot.emissive->pixels.empty())
        return 1;
    const std::vector<double> emissive = variances_around(brightness, *pilot.emissive);
    double deviations = 0;
    for (const double variance : variances)
        deviations += std::sqrt(variance);
    const double mean = deviations / static_cast<double>(variances.size());
    double all = 0, part = 0; // of the image by one sample a pixel on average
    for (std::size_t i = 0; i < variances.size() && mean > 0; ++i) {
        const double samples =
            std::clamp(std::sqrt(variances[i]) / mean, kLeastSamplesShare, kMostSamplesShare);
        all += variances[i] / samples;
        part += std::min(emissive[i], variances[i]) / samples;
    }
    const double best = std::sqrt(part * (1 - kCost) / ((2 * all - part) * kCost));
    return best > 1 ? static_cast<int>(std::lround(best)) : 1;
}

/// The standard deviations of one sample of a pixel, over its brightness.
struct Deviations {
    double rest = 0;   ///< of what its samples find
    double lights = 0; ///< of the seen lights, where they have samples of their own
    double light_cost = kLeastLightCost; ///< of a sample of these, over that of another
};

/// docs/error.md (16), (27).  rest: variance of the other samples; scale2: brightness, squared.
Deviations deviations_at(const LightNoise& noise, std::size_t pixel, double rest, double scale2)
{
    double lights = noise.variance.empty() ? 0 : noise.variance[pixel];
    Deviations out;
    if (!noise.long_paths.empty()) {
        const LongPaths& paths = noise.long_paths[pixel];
        lights = std::max(lights, expected_variance(paths));
        out.light_cost = std::max(kLeastLightCost, kLightCostBySurface * paths.surfaces);
    }
    lights = scale2 > 0 ? lights / scale2 : 0;
    const bool apart = lights > rest;
    out.rest = std::sqrt(rest + (apart ? 0 : lights));
    out.lights = apart ? std::sqrt(lights) : 0;
    return out;
}

/// Returns deviations_at for each pixel of the image.  variances: by pixel of the pilot's images.
std::vector<Deviations> deviations_of(const PilotNoise& pilot, const PilotBrightness& brightness,
                                      const std::vector<double>& variances, int width, int height)
{
    std::vector<Deviations> out;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const std::size_t from = pilot_pixel(pilot, x, y, width, height);
            const glm::dvec3& mean = brightness.mean[from];
            const double value = std::max({mean.x, mean.y, mean.z});
            out.push_back(deviations_at(pilot.lights, out.size(), variances[from],
                                        value * value + brightness.least2));
        }
    return out;
}

/// The least and the most samples that a pixel takes.
struct SampleLimits {
    double least, most, most_lights;

    explicit SampleLimits(double mean)
        : least(std::max(1.0, kLeastSamplesShare * mean)),
          most(std::min(65534.0, kMostSamplesShare * mean)),
          most_lights(std::min(65534.0, kMostLightSamplesShare * mean))
    {
    }
};

/// Returns the samples for each unit of deviation by which all cost as much as `mean` samples of
/// each pixel; 0: none deviates.
double samples_for_deviation(const std::vector<Deviations>& deviations, double mean)
{
    constexpr int kRounds = 6; // each gives others what pixels cannot take
    const SampleLimits limits(mean);
    double scale = 0;
    for (int round = 0; round < kRounds; ++round) {
        double cost = 0;
        for (const Deviations& of : deviations)
            cost += std::min(of.rest, limits.most / scale) +
                    std::min(of.lights * std::sqrt(of.light_cost),
                             of.light_cost * limits.most_lights / scale);
        if (!(cost > 0))
            return 0;
        scale = mean * static_cast<double>(deviations.size()) / cost;
    }
    return scale;
}

/// Returns a count of the mean `wanted`, which is rounded at random by the pixel.
std::uint16_t rounded(double wanted, std::size_t pixel)
{
    return static_cast<std::uint16_t>(wanted +
                                      static_cast<double>(mix_bits(pixel + 1) >> 40) * 0x1p-24);
}

} // namespace

SampleAllocation allocate_samples(const PilotNoise& pilot, int width, int height,
                                  std::uint32_t mean)
{
    SampleAllocation out;
    const PilotBrightness brightness = brightness_of(pilot, width, height);
    const std::vector<double> variances =
        variances_around(brightness, difference_of(pilot.first, pilot.second));
    out.emissive_points = choose_emissive_points(pilot, brightness, variances);
    const std::vector<Deviations> deviations =
        deviations_of(pilot, brightness, variances, width, height);
    const SampleLimits limits(mean);
    const double scale = samples_for_deviation(deviations, mean);
    for (std::size_t i = 0; i < deviations.size(); ++i) {
        const Deviations& of = deviations[i];
        const double wanted = scale > 0 ? std::clamp(scale * of.rest, limits.least, limits.most)
                                        : static_cast<double>(mean);
        out.samples.push_back(rounded(wanted, i));
        if (of.lights > 0) {
            out.lights.resize(deviations.size(), 0);
            out.lights[i] = rounded(std::clamp(scale * of.lights / std::sqrt(of.light_cost),
                                               limits.least, limits.most_lights),
                                    i);
        }
    }
    return out;
}

double relative_variance(const Image& first, const Image& second, const Image& differences)
{
    PilotBrightness brightness =
        brightness_of({first, second, {}, nullptr}, first.width, first.height);
    blur(brightness, first.width, kReach);
    const std::vector<double> squares = square_deviations(brightness, differences);
    return kShareOfSquare * std::reduce(squares.begin(), squares.end(), 0.0) /
           static_cast<double>(std::max<std::size_t>(1, squares.size()));
}

std::uint64_t checksum(const SampleAllocation& allocation)
{
    std::uint64_t sum = static_cast<std::uint64_t>(allocation.emissive_points) - 1;
    for (const auto* counts : {&allocation.samples, &allocation.lights})
        for (const std::uint16_t samples : *counts)
            sum = mix_bits(sum + samples + 1);
    return sum;
}

} // namespace hipmap
