#include "render/film/batch_statistics.h"

#include <algorithm>
#include <limits>

namespace hipmap {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double trace(const Products& a)
{
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        sum += a.at(i, i);
    return sum;
}

double trace_of_square(const Products& a)
{
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t j = 0; j < a.size(); ++j)
            sum += a.at(i, j) * a.at(j, i);
    return sum;
}

/// a * first + b * second, its products with itself.
Products combined(const BatchProducts& products, double a, double b)
{
    Products out(products.first.size());
    for (std::size_t i = 0; i < out.size(); ++i)
        for (std::size_t j = 0; j < out.size(); ++j)
            out.at(i, j) = a * a * products.first.at(i, j) +
                           a * b * (products.both.at(i, j) + products.both.at(j, i)) +
                           b * b * products.second.at(i, j);
    return out;
}

/// The square of the bias, by a ratio and how far off probability may have put it.
struct RatedSquare {
    double value = 0;
    double deviation = 0;
};

RatedSquare square_by(const BatchProducts& products, double ratio)
{
    const Batches& batches = products.narrow;
    const Products whole = combined(products, 1, 1 / (1 - ratio));
    const Spread spread = spread_of(centred(whole, batches), products.channels);
    const double value = product_of_means(whole, batches);
    return {value, std::sqrt(2 * spread.square / pairs_of(batches) +
                             4 * std::max(value, 0.0) * spread.along() / batches.all)};
}

} // namespace

Spread spread_of(const Products& centred, double channels)
{
    const double n = static_cast<double>(centred.size()) - 1;
    if (n < 1)
        return {};
    Spread out;
    out.energy = trace(centred) / n;
    const double most = out.energy * out.energy;
    out.square = most; // as if all channels moved together
    if (n > 1)
        out.square = (trace_of_square(centred) - n * out.energy * out.energy) / ((n - 1) * (n + 2));
    out.square = std::clamp(out.square, most / channels, most);
    return out;
}

Products centred(const Products& products, const Batches& batches)
{
    const std::size_t size = products.size();
    std::vector<double> with_mean(size);
    double mean2 = 0;
    for (std::size_t i = 0; i < size; ++i) {
        for (std::size_t j = 0; j < size; ++j)
            with_mean[i] +=
                (products.at(i, j) + products.at(j, i)) / 2 * batches.passes[j] / batches.all;
        mean2 += with_mean[i] * batches.passes[i] / batches.all;
    }
    Products out(size);
    for (std::size_t i = 0; i < size; ++i)
        for (std::size_t j = 0; j < size; ++j)
            out.at(i, j) =
                std::sqrt(batches.passes[i] * batches.passes[j]) *
                ((products.at(i, j) + products.at(j, i)) / 2 - with_mean[i] - with_mean[j] + mean2);
    return out;
}

double pairs_of(const Batches& batches)
{
    double sum = batches.all * batches.all;
    for (const double passes : batches.passes)
        sum -= passes * passes;
    return sum;
}

double product_of_means(const Products& products, const Batches& batches)
{
    double sum = 0;
    for (std::size_t i = 0; i < products.size(); ++i)
        for (std::size_t j = 0; j < products.size(); ++j)
            if (i != j)
                sum += batches.passes[i] * batches.passes[j] * products.at(i, j);
    return sum / pairs_of(batches);
}

double f_quantile(double z, double above, double below)
{
    const double a = 2 / (9 * above), b = 2 / (9 * below);
    const double middle = (1 - a) * (1 - b), bottom = (1 - b) * (1 - b) - b * z * z;
    if (bottom <= 0)
        return z > 0 ? kInfinity : 0;
    const double width = std::sqrt((1 - a) * (1 - a) * b + (1 - b) * (1 - b) * a - a * b * z * z);
    const double root = std::max((middle + z * width) / bottom, 0.0);
    return root * root * root;
}

namespace {

/// Returns the order of a bias, from its square and the square that is left with radii narrower by
/// one step.
double order_of(double square, double left)
{
    constexpr double kLowest = 1, kHighest = 4;
    if (!(square > 0))
        return 2;
    if (!(left > 0))
        return kHighest;
    return std::clamp(std::log(left / square) / (2 * std::log(kNarrowing)), kLowest, kHighest);
}

} // namespace

BiasSquare bias_square(const BatchProducts& products)
{
    constexpr double kLeast = kNarrowing * kNarrowing, kMost = kNarrowing; // orders 2 and 1
    const Batches& batches = products.narrow;
    if (batches.batch.size() < 2)
        return {0, 2, 0, {0, kInfinity}};
    const double first = product_of_means(products.first, batches);
    const double both = product_of_means(products.both, batches);
    const Spread spread = spread_of(centred(products.first, batches), products.channels);

    BiasSquare out;
    out.photon = spread.energy; // docs/error.md (12)
    const double ratio = first > 0 ? std::clamp(both / first, kLeast, kMost) : kLeast;
    const Spread rest =
        spread_of(centred(combined(products, -ratio, 1), batches), products.channels);
    const double ratio_deviation =
        std::sqrt(2 * std::sqrt(rest.square * spread.square) / pairs_of(batches) +
                  std::max(first, 0.0) * rest.along() / batches.all);
    const double off = first > 0 ? kZ * ratio_deviation / first : kInfinity;
    const double middle = (ratio + kLeast) / 2;
    out.value = square_by(products, middle).value;
    out.order = order_of(out.value, product_of_means(products.second, batches) /
                                        ((1 - middle) * (1 - middle)));
    const RatedSquare low = square_by(products, kLeast);
    const RatedSquare high = square_by(products, std::min(ratio + off, kMost));
    out.interval = {low.value - kZ * low.deviation,
                    std::max(high.value, 0.0) + kZ * high.deviation};
    return out;
}

} // namespace hipmap
