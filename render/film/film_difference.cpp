#include "render/film/film_difference.h"

#include "render/film/batch_statistics.h"

#include <limits>

namespace hipmap {

namespace {

/// The mean of each batch.
std::array<double, kBatches> batch_means(const ChannelStatistics& channel, const Batches& batches)
{
    std::array<double, kBatches> out{};
    for (std::size_t i = 0; i < batches.batch.size(); ++i)
        out[i] = channel.mean + channel.deviation[i] / std::sqrt(batches.passes[i]);
    return out;
}

/// Products of the differences of batches, each relative, summed over the channels.
Products difference_products(const Film& film, const Film& other)
{
    const ChannelReader first(film), second(other);
    const Batches& batches = first.wide();
    Products out(batches.batch.size());
    for (std::size_t pixel = 0; pixel < film.pixel_count(); ++pixel)
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const ChannelStatistics read = first.read(pixel, channel);
            const std::array<double, kBatches> a = batch_means(read, batches);
            const std::array<double, kBatches> b =
                batch_means(second.read(pixel, channel), batches);
            for (std::size_t i = 0; i < out.size(); ++i)
                for (std::size_t j = 0; j < out.size(); ++j)
                    out.at(i, j) += read.steady * (a[i] - b[i]) * (a[j] - b[j]);
        }
    return out;
}

/// What is left without batch `left`.
double square_without(const Products& products, const Batches& batches, std::size_t left)
{
    Products some(products.size() - 1);
    Batches others;
    for (std::size_t i = 0; i < products.size(); ++i) {
        if (i == left)
            continue;
        for (std::size_t j = 0; j < products.size(); ++j)
            if (j != left)
                some.at(i - (i > left ? 1 : 0), j - (j > left ? 1 : 0)) = products.at(i, j);
        others.batch.push_back(batches.batch[i]);
        others.passes.push_back(batches.passes[i]);
        others.all += batches.passes[i];
    }
    return product_of_means(some, others);
}

/// The jackknife's standard deviation over batches.
double jackknife(const Products& products, const Batches& batches)
{
    const std::size_t size = products.size();
    double sum = 0, squares = 0;
    for (std::size_t left = 0; left < size; ++left) {
        const double square = square_without(products, batches, left);
        sum += square;
        squares += square * square;
    }
    const auto n = static_cast<double>(size);
    return std::sqrt(std::max(squares - sum * sum / n, 0.0) * (n - 1) / n);
}

} // namespace

FilmDifference difference_of(const Film& film, const Film& other)
{
    const Batches batches = ChannelReader(film).wide();
    const Products products = difference_products(film, other);
    const double channels = 3 * static_cast<double>(film.pixel_count());
    FilmDifference out;
    out.spread = std::numeric_limits<double>::infinity();
    if (products.size() < 2 || channels == 0)
        return out;
    out.square = product_of_means(products, batches) / channels;
    if (products.size() > 2)
        out.spread = jackknife(products, batches) / channels;
    return out;
}

} // namespace hipmap
