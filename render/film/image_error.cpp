#include "render/film/image_error.h"

#include "common/math/square.h"
#include "render/film/batch_statistics.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <limits>

namespace hipmap {

namespace {

/// Sum of squares of the noise over the channels.
struct NoiseSquare {
    double value = 0;
    double most = 0;   ///< by the weights w' of (5)
    Interval interval; ///< for what is in this image, besides
};

/// docs/error.md (4) to (7).  At least two batches.
NoiseSquare noise_square(const BatchProducts& products, const Spread& spread)
{
    const double others = static_cast<double>(products.wide.batch.size()) - 1;
    NoiseSquare out;
    out.value = products.noise / (others * products.wide.all);
    out.most = std::max(products.most_noise / (others * products.wide.all), out.value);
    if (out.value > 0) {
        const double energy = products.noise / others;
        const double rare = std::max(products.fourth, 0.0) / (2 * (others + 1) * energy * energy);
        const double above = 1 / (1 / spread.freedom() + rare);
        const double below = 1 / (1 / (spread.freedom() * others) + rare);
        out.interval = {out.value * f_quantile(-kZ, above, below),
                        out.value * f_quantile(kZ, above, below)};
    }
    return out;
}

/// docs/error.md (18)
double clamp_square(const Film& film, const BatchProducts& products)
{
    if (film.cut.empty() || products.narrow.batch.size() < 2)
        return 0;
    return std::max(product_of_means(products.cut, products.narrow), 0.0);
}

/// Sum of squares of what clamped values may lack, docs/error.md (23).
double saturated_square(const Film& film, const BatchProducts& products)
{
    return std::min(static_cast<double>(film.saturated), products.channels);
}

} // namespace

std::optional<ImageError> estimate_error(const Film& film)
{
    const BatchProducts products = batch_products(film);
    if (products.wide.batch.size() < 2 || products.channels == 0)
        return std::nullopt;
    const Spread spread = spread_of(products.deviations, products.channels);
    const NoiseSquare noise = noise_square(products, spread);
    BiasSquare bias;
    if (film.bias == BiasKnowledge::from_radii)
        bias = bias_square(products);
    const double known = std::max(bias.value, 0.0);
    const double clamped = clamp_square(film, products);
    const double sum = noise.value + known + clamped;

    ImageError out;
    out.bias = film.bias;
    out.noise2 = noise.value / products.channels;
    if (bias.photon > 0) // as a part: both are told too low by the weight of the image itself
        out.photon2 = out.noise2 * std::min(bias.photon / spread.energy, 1.0);
    out.bias2 = bias.value / products.channels;
    out.clamp2 = clamped / products.channels;
    out.order = bias.order;
    out.error = std::sqrt(sum / products.channels);
    out.high = std::numeric_limits<double>::infinity();
    if (products.wide.batch.size() < kFewestBatches)
        return out;
    // docs/error.md (11)
    const double both2 = kZ * kZ * 4 * known * spread.along() / products.wide.all;
    const double below = std::sqrt(square_of(noise.value - noise.interval.low) +
                                   square_of(known - bias.interval.low) + both2);
    const double above = std::sqrt(square_of(noise.interval.high - noise.value) +
                                   square_of(bias.interval.high - bias.value) + both2);
    out.low = std::sqrt(std::max(sum - below, 0.0) / products.channels);
    const double high2 = (std::max(noise.most + bias.value + clamped + above, sum) +
                          saturated_square(film, products)) /
                         products.channels;
    out.missing2 = missing_square(film.expected, count(film.passes));
    out.high = std::sqrt(std::max(high2, out.error * out.error + out.missing2));
    return out;
}

ErrorLayers error_layers(const Film& film)
{
    const ChannelReader reader(film);
    ErrorLayers out{Image(film.width, film.height), {}, Image(film.width, film.height)};
    const bool biased = film.bias == BiasKnowledge::from_radii;
    if (biased)
        out.bias = Image(film.width, film.height);
    tbb::parallel_for(std::size_t{0}, film.pixel_count(), [&](std::size_t i) {
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const ChannelStatistics found = reader.read(i, channel);
            const int c = static_cast<int>(channel);
            double mean = 0, same = 0, squares = 0;
            for (std::size_t j = 0; j < kNarrowBatches && found.passes > 0; ++j) {
                const double passes = found.narrow[j];
                const double bias = found.first[j] + kSmoothRest * found.second[j];
                mean += passes * bias / found.passes;
                same += square_of(passes * bias);
                squares += square_of(passes);
            }
            const double pairs = square_of(found.passes) - squares;
            const double bias2 =
                biased && pairs > 0 ? (square_of(mean * found.passes) - same) / pairs : 0;
            out.noise.pixels[i][c] = static_cast<float>(std::sqrt(found.variance));
            if (biased)
                out.bias.pixels[i][c] = static_cast<float>(mean);
            out.error.pixels[i][c] =
                static_cast<float>(std::sqrt(found.variance + std::max(bias2, 0.0)));
        }
    });
    return out;
}

} // namespace hipmap
