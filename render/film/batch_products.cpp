#include "render/film/batch_products.h"

#include <algorithm>

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

double mean_of_channels(const Image& image)
{
    double sum = 0;
    for (const Rgb& pixel : image.pixels)
        sum += double{pixel.x} + double{pixel.y} + double{pixel.z};
    return image.pixels.empty() ? 0 : sum / (3 * static_cast<double>(image.pixels.size()));
}

/// How many times w the weight of a batch may be, unless 1/D is more.
constexpr double kMostWeight = 3;

/// docs/error.md (5)
struct RelativeWeight {
    double value = 0; ///< w
    double plain = 0; ///< 1/D
};

RelativeWeight relative_weight(double mean, double variance, double dark)
{
    const double seen = mean * mean;
    const double square = seen > 0 ? seen * seen / (seen + variance) : 0;
    const double plain = square + dark;
    if (!(plain > 0))
        return {};
    return {1 / (plain + 4 * variance * square / plain), 1 / plain};
}

template <typename A, typename B>
void add_products(Products& into, double weight, const A& a, const B& b)
{
    for (std::size_t i = 0; i < into.size(); ++i)
        for (std::size_t j = 0; j < into.size(); ++j)
            into.at(i, j) += weight * a[i] * b[j];
}

} // namespace

ChannelReader::ChannelReader(const Film& film)
    : film_(film), wide_(filled_batches(film.passes, kBatches)), unit_(std::ldexp(1.0, -film.scale))
{
    if (film.bias == BiasKnowledge::from_radii)
        narrow_ = filled_batches(film.passes, kNarrowBatches);
    const double dark = kDarkShare * mean_of_channels(film_image(film));
    dark_ = dark * dark;
}

double ChannelReader::sum(const std::vector<std::int64_t>& sums, std::uint64_t batch,
                          std::size_t pixel, std::size_t channel) const
{
    return unit_ * static_cast<double>(sums[(batch * film_.pixel_count() + pixel) * 3 + channel]);
}

ChannelStatistics ChannelReader::read(std::size_t pixel, std::size_t channel) const
{
    std::array<double, kBatches> sums{}, kept{};
    ChannelStatistics out;
    double total = 0;
    for (std::size_t i = 0; i < wide_.batch.size(); ++i) {
        const auto passes = static_cast<std::uint64_t>(wide_.passes[i]);
        kept[i] = static_cast<double>(kept_passes(film_, passes, pixel, wide_.batch[i]));
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
    const RelativeWeight weight = relative_weight(out.mean, out.variance, dark_);
    const double most = std::max(kMostWeight * weight.value, weight.plain);
    out.weight = weight.value;
    for (std::size_t i = 0; i < wide_.batch.size() && out.batches > 1; ++i) {
        if (kept[i] == 0)
            continue;
        const double square = out.deviation[i] * out.deviation[i];
        const double without = weight_without(out, squares, i, sums[i], kept[i]);
        out.noise += std::min(without, most) * square;
        out.most_noise += without * square;
    }
    if (film_.bias == BiasKnowledge::from_radii)
        read_narrow(pixel, channel, out);
    return out;
}

/// The weight by all batches but `i`: what is bright by chance must not hide it.
double ChannelReader::weight_without(const ChannelStatistics& all, double squares, std::size_t i,
                                     double sum, double kept) const
{
    const double others = all.passes - kept;
    const double mean = (all.mean * all.passes - sum) / others;
    const double own = all.deviation[i] * all.deviation[i] * all.passes / others;
    const double variance =
        all.batches > 2 ? std::max(squares - own, 0.0) / ((all.batches - 2) * others) : 0;
    return relative_weight(mean, variance, dark_).value;
}

void ChannelReader::read_narrow(std::size_t pixel, std::size_t channel,
                                ChannelStatistics& out) const
{
    for (std::size_t i = 0; i < narrow_.batch.size(); ++i) {
        double wide = 0, kept = 0;
        for (std::size_t j = 0; j < wide_.batch.size(); ++j) {
            const std::uint64_t batch = wide_.batch[j];
            if (batch % kNarrowBatches != narrow_.batch[i])
                continue;
            wide += sum(film_.radiance, batch, pixel, channel);
            kept += static_cast<double>(
                kept_passes(film_, static_cast<std::uint64_t>(wide_.passes[j]), pixel, batch));
        }
        if (kept == 0)
            continue;
        const double narrow = sum(film_.narrow, narrow_.batch[i], pixel, channel);
        const double narrower = sum(film_.narrower, narrow_.batch[i], pixel, channel);
        out.first[i] = (wide - narrow) / kept;
        out.second[i] = (narrow - narrower) / kept;
    }
}

BatchProducts batch_products(const Film& film)
{
    const ChannelReader reader(film);
    BatchProducts out;
    out.wide = reader.wide();
    out.narrow = reader.narrow();
    out.channels = 3 * static_cast<double>(film.pixel_count());
    out.deviations = Products(out.wide.batch.size());
    out.first = out.both = out.second = Products(out.narrow.batch.size());
    for (std::size_t pixel = 0; pixel < film.pixel_count(); ++pixel)
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const ChannelStatistics found = reader.read(pixel, channel);
            out.noise += found.noise;
            out.most_noise += found.most_noise;
            add_products(out.deviations, found.weight, found.deviation, found.deviation);
            add_products(out.first, found.weight, found.first, found.first);
            add_products(out.both, found.weight, found.first, found.second);
            add_products(out.second, found.weight, found.second, found.second);
        }
    return out;
}

} // namespace hipmap
