#include "render/film/image_error.h"

#include "render/film/batch_statistics.h"

#include <algorithm>
#include <limits>

namespace hipmap {

namespace {

/// For the sum of squares of the noise that is in this image.
Interval noise_interval(double noise, const Spread& spread, double batches)
{
    if (noise == 0)
        return {};
    const double freedom = spread.freedom();
    const double below = freedom * (batches - 1);
    return {noise * f_quantile(-kZ, freedom, below), noise * f_quantile(kZ, freedom, below)};
}

double square_of(double x)
{
    return x * x;
}

} // namespace

std::optional<ImageError> estimate_error(const Film& film)
{
    const BatchProducts products = batch_products(film);
    if (products.wide.batch.size() < 2)
        return std::nullopt;
    const Spread spread = spread_of(products.deviations, products.channels);
    const double batches = static_cast<double>(products.wide.batch.size());
    const double noise = products.noise / ((batches - 1) * products.wide.all);
    const double unsure = (noise - spread.energy / products.wide.all) / 2;
    const Interval noisy = noise_interval(noise, spread, batches);
    BiasSquare bias;
    if (film.bias == BiasKnowledge::from_radii)
        bias = bias_square(products);

    // docs/error.md (11)
    const double known = std::max(bias.value, 0.0);
    const double both2 =
        square_of(unsure) + kZ * kZ * 4 * known * spread.along() / products.wide.all;
    const double below =
        std::sqrt(square_of(noise - noisy.low) + square_of(known - bias.interval.low) + both2);
    const double above = std::sqrt(square_of(noisy.high - noise) +
                                   square_of(bias.interval.high - bias.value) + both2);
    const double sum = noise + known;

    ImageError out;
    out.bias = film.bias;
    out.noise2 = noise / products.channels;
    out.bias2 = bias.value / products.channels;
    if (bias.ratio > 0)
        out.order = std::log(bias.ratio) / std::log(kNarrowing);
    out.error = std::sqrt(sum / products.channels);
    out.high = std::numeric_limits<double>::infinity();
    if (products.wide.batch.size() < kBatches)
        return out;
    out.low = std::sqrt(std::max(sum - below, 0.0) / products.channels);
    out.high = std::sqrt(std::max(noise + bias.value + above, sum) / products.channels);
    return out;
}

ErrorLayers error_layers(const Film& film, double order)
{
    const ChannelReader reader(film);
    ErrorLayers out{Image(film.width, film.height), {}, Image(film.width, film.height)};
    const bool biased = film.bias == BiasKnowledge::from_radii;
    if (biased)
        out.bias = Image(film.width, film.height);
    const double factor = 1 / (1 - std::pow(kNarrowing, order));
    const Batches& batches = reader.narrow();
    for (std::size_t i = 0; i < film.pixel_count(); ++i)
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const ChannelStatistics found = reader.read(i, channel);
            const int c = static_cast<int>(channel);
            double mean = 0, same = 0;
            for (std::size_t j = 0; j < batches.batch.size(); ++j) {
                mean += batches.passes[j] * found.first[j] / batches.all;
                same += square_of(batches.passes[j] * found.first[j]);
            }
            double bias2 = 0;
            if (batches.batch.size() > 1)
                bias2 = (square_of(mean * batches.all) - same) / pairs_of(batches);
            out.noise.pixels[i][c] = static_cast<float>(std::sqrt(found.variance));
            if (biased)
                out.bias.pixels[i][c] = static_cast<float>(factor * mean);
            out.error.pixels[i][c] = static_cast<float>(
                std::sqrt(found.variance + factor * factor * std::max(bias2, 0.0)));
        }
    return out;
}

} // namespace hipmap
