#include "render/film/rare_samples.h"

#include "common/math/poisson.h"

#include <algorithm>
#include <cmath>

namespace hipmap {

namespace {

/// Between pixels that one sample counts in by the widest filter.
constexpr std::size_t kReach = 2;

/// Samples of like brightness that tell how often such samples hit a pixel: so many, with noise up
/// to so many times more or less, which goes as the square of the brightness.
constexpr std::size_t kAlike = 16;
constexpr double kAlikeNoise = 256;

/// Hits of a pixel from which on removal adds more error than it takes.
constexpr double kMostHits = 0.5;

/// A rare sample: pixels side by side that one batch lights.
struct Sample {
    double noise = 0;
    bool again = false;
    double hits = 0; ///< expected, of each pixel that it may reach

    bool is_removed() const { return !again && hits <= kMostHits; }
};

bool is_of_one_sample(const OutstandingPixel& a, const OutstandingPixel& b, std::size_t width)
{
    const std::size_t left = std::min(a.pixel % width, b.pixel % width);
    const std::size_t right = std::max(a.pixel % width, b.pixel % width);
    return a.batch == b.batch && a.again == b.again && right - left <= kReach;
}

/// Returns [pixels] the number of each pixel's sample, by first pixel.
std::vector<std::size_t> find_samples(std::span<const OutstandingPixel> pixels, std::size_t width)
{
    std::vector<std::size_t> sample_of;
    std::size_t count = 0;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        std::size_t sample = count;
        for (std::size_t j = i; j-- > 0 && sample == count;) {
            if (pixels[i].pixel / width - pixels[j].pixel / width > kReach)
                break;
            if (is_of_one_sample(pixels[i], pixels[j], width))
                sample = sample_of[j];
        }
        count += sample == count ? 1 : 0;
        sample_of.push_back(sample);
    }
    return sample_of;
}

/// Returns the samples alike about a place in an order of falling brightness: dimmer ones first, as
/// the brighter are the rarer.
std::span<Sample* const> find_alike(std::span<Sample* const> order, std::size_t place)
{
    const double noise = order[place]->noise;
    std::size_t begin = place, end = place + 1;
    while (end < order.size() && end - begin < kAlike && order[end]->noise * kAlikeNoise >= noise)
        ++end;
    while (begin > 0 && end - begin < kAlike && order[begin - 1]->noise <= noise * kAlikeNoise)
        --begin;
    return order.subspan(begin, end - begin);
}

/// Sets the hits of each by those of samples alike, docs/error.md (25).
void count_hits(std::vector<Sample>& samples)
{
    std::vector<Sample*> order;
    for (Sample& sample : samples)
        order.push_back(&sample);
    std::ranges::stable_sort(order, std::ranges::greater{},
                             [](const Sample* sample) { return sample->noise; });
    for (std::size_t i = 0; i < order.size(); ++i) {
        double again = 0.5, once = 1;
        for (const Sample* alike : find_alike(order, i))
            if (alike->again)
                again += 1;
            else // which is hit more often by as much as it is dimmer
                once += std::sqrt(order[i]->noise / alike->noise);
        order[i]->hits = 2 * again / once;
    }
}

} // namespace

RareSamples judge_rare_samples(std::span<const OutstandingPixel> pixels, std::size_t width)
{
    const std::vector<std::size_t> sample_of = find_samples(pixels, width);
    std::vector<Sample> samples;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        samples.resize(std::max(samples.size(), sample_of[i] + 1));
        samples[sample_of[i]].noise += pixels[i].noise;
        samples[sample_of[i]].again = pixels[i].again;
    }
    count_hits(samples);

    RareSamples out;
    double light = 0, sum = 0, squares = 0, hits = 0, count = 0;
    for (const Sample& sample : samples)
        if (sample.is_removed()) {
            light += std::sqrt(sample.noise);
            sum += sample.noise;
            squares += sample.noise * sample.noise;
            hits = std::max(hits, sample.hits);
            count += 1;
        }
    if (squares > 0) { // as much is known of their mean as by so many alike
        const double alike = sum * sum / squares;
        out.missing = 2 * light * light * hits / count;
        out.most_missing = out.missing * most_expected(alike) / alike;
    }
    for (const std::size_t sample : sample_of)
        out.removed.push_back(samples[sample].is_removed() ? 1 : 0);
    return out;
}

} // namespace hipmap
