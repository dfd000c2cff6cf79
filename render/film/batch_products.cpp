#include "render/film/batch_products.h"

#include "common/math/sort_eight.h"
#include "render/film/batch_statistics.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <limits>

namespace hipmap {

namespace {

/// What is called dark, as a share of the mean of the image.
constexpr double kDarkShare = 0.1;

Batches filled_batches(const PassSet& passes, std::uint64_t batches)
{
    Batches out;
    for (std::uint64_t batch = 0; batch < batches; ++batch) {
        const std::uint64_t found = count(passes, batches, batch);
        if (found == 0)
            continue;
        out.batch.push_back(batch);
        out.passes.push_back(static_cast<double>(found));
        out.all += static_cast<double>(found);
    }
    return out;
}

/// Returns the mean over the channels of those pixels that hold passes.
double mean_of_channels(const Film& film, const Image& image)
{
    double sum = 0, pixels = 0;
    for (const Rgb& pixel : image.pixels)
        sum += double{pixel.x} + double{pixel.y} + double{pixel.z};
    for (const FilmPart& part : parts_of(film))
        pixels += static_cast<double>(part.pixels.width()) * part.pixels.height();
    return pixels == 0 ? 0 : sum / (3 * pixels);
}

/// Returns the factor that makes the deviations of a pixel, which holds fewer passes than the film,
/// as large as if (4) of docs/error.md divided them by the pixel's own passes and batches.
double scale_of_deviations(const ChannelStatistics& pixel, const Batches& film)
{
    const double batches = static_cast<double>(film.batch.size());
    if (pixel.batches < 2 || (pixel.batches == batches && pixel.passes == film.all))
        return 1;
    return std::sqrt((batches - 1) * film.all / ((pixel.batches - 1) * pixel.passes));
}

void scale_deviations(ChannelStatistics& pixel, double scale)
{
    for (double& deviation : pixel.deviation)
        deviation *= scale;
    pixel.noise *= scale * scale;
    pixel.most_noise *= scale * scale;
}

/// Returns the factors that do the same for the differences of radii, by the pairs of passes of
/// docs/error.md (8).
std::array<double, kNarrowBatches> scales_of_differences(const ChannelStatistics& pixel,
                                                         const Batches& film)
{
    double all = 0, squares = 0;
    for (const double passes : pixel.narrow) {
        all += passes;
        squares += passes * passes;
    }
    std::array<double, kNarrowBatches> out;
    out.fill(1);
    const double pairs = all * all - squares;
    if (all == film.all)
        return out;
    for (std::size_t i = 0; i < film.batch.size(); ++i)
        out[i] =
            pairs > 0 ? pixel.narrow[i] / film.passes[i] * std::sqrt(pairs_of(film) / pairs) : 0;
    return out;
}

/// docs/error.md (5)
double relative_weight(double mean, double variance, double dark)
{
    const double seen = mean * mean;
    const double square = seen > 0 ? seen * seen / (seen + variance) : 0;
    const double plain = square + dark;
    return plain > 0 ? 1 / (plain + 4 * variance * square / plain) : 0;
}

/// Returns the median of the channel in the pixels around; the pixel's own where there are none.
double median_around(const Image& image, int x, int y, int channel)
{
    std::array<float, 8> values;
    values.fill(std::numeric_limits<float>::infinity()); // stays behind what is found
    std::size_t size = 0;
    for (int v = std::max(0, y - 1); v <= std::min(image.height - 1, y + 1); ++v)
        for (int u = std::max(0, x - 1); u <= std::min(image.width - 1, x + 1); ++u)
            if (u != x || v != y)
                values[size++] = image.at(u, v)[channel];
    if (size == 0)
        return image.at(x, y)[channel];
    sort_eight(values);
    return (double{values[(size - 1) / 2]} + values[size / 2]) / 2;
}

template <typename A, typename B>
void add_products(Products& into, double weight, const A& a, const B& b)
{
    for (std::size_t i = 0; i < into.size(); ++i)
        for (std::size_t j = 0; j < into.size(); ++j)
            into.at(i, j) += weight * a[i] * b[j];
}

/// Fisher's k-statistic: of `n` values, whose expectation is their fourth cumulant.
double fourth_cumulant(const std::array<double, kBatches>& values, double n)
{
    if (n < 4)
        return 0;
    double mean = 0, second = 0, fourth = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i)
        mean += values[i] / n;
    for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i) {
        const double square = (values[i] - mean) * (values[i] - mean);
        second += square / n;
        fourth += square * square / n;
    }
    return n * n * ((n + 1) * fourth - 3 * (n - 1) * second * second) /
           ((n - 1) * (n - 2) * (n - 3));
}

} // namespace

ChannelReader::ChannelReader(const Film& film)
    : film_(film), kept_(film), wide_(filled_batches(film.passes, kBatches)),
      mean_(film_image(film)), unit_(std::ldexp(1.0, -film.scale))
{
    if (film.bias == BiasKnowledge::from_radii || !film.cut.empty())
        narrow_ = filled_batches(film.passes, kNarrowBatches);
    const double dark = kDarkShare * mean_of_channels(film, mean_);
    dark_ = dark * dark;
}

double ChannelReader::sum(const std::vector<std::int64_t>& sums, std::uint64_t batch,
                          std::size_t pixel, std::size_t channel) const
{
    return unit_ * static_cast<double>(sums[(batch * film_.pixel_count() + pixel) * 3 + channel]);
}

/// Returns the passes of a filled batch that kept a sample of the pixel.
double ChannelReader::kept_of(std::size_t pixel, std::size_t i) const
{
    if (film_.parts.empty() && film_.lost.empty()) [[likely]]
        return wide_.passes[i];
    return static_cast<double>(kept_.of_batch(pixel, wide_.batch[i]));
}

ChannelStatistics ChannelReader::read(std::size_t pixel, std::size_t channel) const
{
    std::array<double, kBatches> sums{}, kept{};
    ChannelStatistics out;
    double total = 0;
    for (std::size_t i = 0; i < wide_.batch.size(); ++i) {
        kept[i] = kept_of(pixel, i);
        sums[i] = sum(film_.radiance, wide_.batch[i], pixel, channel);
        total += sums[i];
        out.passes += kept[i];
        out.batches += kept[i] > 0 ? 1 : 0;
    }
    if (out.passes == 0)
        return out;
    out.mean = total / out.passes;
    double squares = 0;
    for (std::size_t i = 0; i < wide_.batch.size(); ++i) {
        if (kept[i] > 0)
            out.deviation[i] = (sums[i] - kept[i] * out.mean) / std::sqrt(kept[i]);
        squares += out.deviation[i] * out.deviation[i];
    }
    if (out.batches > 1)
        out.variance = squares / ((out.batches - 1) * out.passes);
    out.weight = relative_weight(out.mean, out.variance, dark_);
    out.unbiased = out.mean;
    add_by_narrow_batch(kept, out.narrow);
    if (film_.bias == BiasKnowledge::from_radii)
        read_narrow(pixel, channel, out);
    if (!film_.cut.empty())
        read_cut(pixel, channel, out);
    out.bias_weight = relative_weight(out.unbiased, out.variance, dark_);
    out.steady = weight_by_neighbours(out, pixel, channel);
    out.noise = out.steady * squares;
    for (std::size_t i = 0; i < wide_.batch.size() && out.batches > 1; ++i)
        if (kept[i] > 0)
            out.most_noise += weight_without(out, squares, i, sums[i], kept[i]) * out.deviation[i] *
                              out.deviation[i];
    if (const double scale = scale_of_deviations(out, wide_); scale != 1)
        scale_deviations(out, scale);
    return out;
}

/// kept: passes by wide batch.
void ChannelReader::add_by_narrow_batch(const std::array<double, kBatches>& kept,
                                        std::array<double, kNarrowBatches>& into) const
{
    for (std::size_t i = 0; i < wide_.batch.size(); ++i)
        for (std::size_t j = 0; j < narrow_.batch.size(); ++j)
            if (wide_.batch[i] % kNarrowBatches == narrow_.batch[j])
                into[j] += kept[i];
}

/// What the mean would be without the bias that is plain to see; where it is not, the mean.
double ChannelReader::without_bias(const ChannelStatistics& biased) const
{
    constexpr double kPlain = 1; // standard errors
    const auto size = static_cast<double>(
        std::ranges::count_if(biased.narrow, [](double passes) { return passes > 0; }));
    if (size < 2)
        return biased.mean;
    double sum = 0, squares = 0;
    for (const double difference : biased.first)
        sum += difference;
    for (std::size_t i = 0; i < narrow_.batch.size(); ++i)
        if (biased.narrow[i] > 0)
            squares += (biased.first[i] - sum / size) * (biased.first[i] - sum / size);
    const double sure = sum / size - kPlain * std::sqrt(squares / (size * (size - 1)));
    if (!(sure > 0) || !(biased.mean > 0))
        return biased.mean;
    return std::max(biased.mean - kSmoothRest * sure, 0.0);
}

/// By what the pixels around have, as far as the channel's own noise allows for it.
double ChannelReader::weight_by_neighbours(const ChannelStatistics& own, std::size_t pixel,
                                           std::size_t channel) const
{
    const int width = film_.width, at = static_cast<int>(pixel);
    const double around = median_around(mean_, at % width, at / width, static_cast<int>(channel));
    const double noise = std::sqrt(own.variance);
    const double value =
        std::clamp(around, std::max(own.unbiased - noise, 0.0), own.unbiased + noise);
    const double square = value * value + dark_;
    return square > 0 ? 1 / square : 0;
}

/// The weight by all batches but `i`: a value that is bright by chance must not hide itself.
double ChannelReader::weight_without(const ChannelStatistics& all, double squares, std::size_t i,
                                     double sum, double kept) const
{
    const double others = all.passes - kept;
    const double mean = (all.mean * all.passes - sum) / others;
    const double own = all.deviation[i] * all.deviation[i] * all.passes / others;
    const double variance =
        all.batches > 2 ? std::max(squares - own, 0.0) / ((all.batches - 2) * others) : 0;
    return relative_weight(mean, variance, dark_);
}

void ChannelReader::read_narrow(std::size_t pixel, std::size_t channel,
                                ChannelStatistics& out) const
{
    for (std::size_t i = 0; i < narrow_.batch.size(); ++i) {
        const double kept = out.narrow[i];
        double wide = 0;
        for (std::size_t j = 0; j < wide_.batch.size(); ++j) {
            const std::uint64_t batch = wide_.batch[j];
            if (batch % kNarrowBatches != narrow_.batch[i])
                continue;
            wide += sum(film_.radiance, batch, pixel, channel);
        }
        if (kept == 0)
            continue;
        const double narrow = sum(film_.narrow, narrow_.batch[i], pixel, channel);
        const double narrower = sum(film_.narrower, narrow_.batch[i], pixel, channel);
        out.first[i] = (wide - narrow) / kept;
        out.second[i] = (narrow - narrower) / kept;
    }
    out.unbiased = without_bias(out);
}

void ChannelReader::read_cut(std::size_t pixel, std::size_t channel, ChannelStatistics& out) const
{
    double all = 0;
    for (std::size_t i = 0; i < narrow_.batch.size(); ++i) {
        const double taken = sum(film_.cut, narrow_.batch[i], pixel, channel);
        out.cut[i] = out.narrow[i] > 0 ? taken / out.narrow[i] : 0;
        all += taken;
    }
    out.unbiased += all / out.passes;
}

namespace {

void add_channel(BatchProducts& out, const ChannelStatistics& found, bool clamped)
{
    out.noise += found.noise;
    out.most_noise += found.most_noise;
    add_products(out.deviations, found.weight, found.deviation, found.deviation);
    if (out.narrow.batch.empty())
        return;
    const std::array<double, kNarrowBatches> scales = scales_of_differences(found, out.narrow);
    std::array<double, kNarrowBatches> first = found.first, second = found.second, cut = found.cut;
    for (std::size_t i = 0; i < kNarrowBatches; ++i) {
        first[i] *= scales[i];
        second[i] *= scales[i];
        cut[i] *= scales[i];
    }
    add_products(out.first, found.bias_weight, first, first);
    add_products(out.both, found.bias_weight, first, second);
    add_products(out.second, found.bias_weight, second, second);
    if (clamped)
        add_products(out.cut, found.bias_weight, cut, cut);
}

void add_pixel(BatchProducts& out, const Film& film, const ChannelReader& reader, std::size_t pixel)
{
    std::array<double, kBatches> of_pixel{};
    for (std::size_t channel = 0; channel < 3; ++channel) {
        const ChannelStatistics found = reader.read(pixel, channel);
        out.channels += film.parts.empty() || found.batches > 1 ? 1 : 0;
        const double root = std::sqrt(found.steady / 3);
        for (std::size_t i = 0; i < out.wide.batch.size(); ++i)
            of_pixel[i] += root * found.deviation[i];
        add_channel(out, found, !film.cut.empty());
    }
    out.fourth += fourth_cumulant(of_pixel, static_cast<double>(out.wide.batch.size()));
}

/// The sums of some pixels and those of others; of the same batches.
BatchProducts sum_of(BatchProducts a, const BatchProducts& b)
{
    a.channels += b.channels;
    a.noise += b.noise;
    a.most_noise += b.most_noise;
    a.fourth += b.fourth;
    a.deviations += b.deviations;
    a.first += b.first;
    a.both += b.both;
    a.second += b.second;
    a.cut += b.cut;
    return a;
}

} // namespace

BatchProducts batch_products(const Film& film)
{
    const ChannelReader reader(film);
    BatchProducts none;
    none.wide = reader.wide();
    none.narrow = reader.narrow();
    none.deviations = Products(none.wide.batch.size());
    none.first = none.both = none.second = none.cut = Products(none.narrow.batch.size());
    // Deterministic: sums of doubles depend on their order.
    return tbb::parallel_deterministic_reduce(
        tbb::blocked_range<std::size_t>(0, film.pixel_count(), kPixelsOfTask), none,
        [&](const tbb::blocked_range<std::size_t>& pixels, BatchProducts sums) {
            for (std::size_t pixel = pixels.begin(); pixel < pixels.end(); ++pixel)
                add_pixel(sums, film, reader, pixel);
            return sums;
        },
        sum_of);
}

} // namespace hipmap
