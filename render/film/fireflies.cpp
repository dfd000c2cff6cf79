#include "render/film/fireflies.h"

#include "render/film/batch_products.h"

#include <algorithm>
#include <numeric>

namespace hipmap {

namespace {

/// The pixels that may be fireflies: one in kPixelsPerFirefly, and kLeastFireflies at least, the
/// pixels that one sample counts in by the widest filter.
constexpr std::size_t kPixelsPerFirefly = 1000;
constexpr std::size_t kLeastFireflies = 9;
/// An image with fewer pixels for each of these is too small to tell.
constexpr std::size_t kLeastOthers = 10;
/// The least ratio of the noise of a firefly to the mean of the pixels that cannot be fireflies.
constexpr double kBright = 100;
/// The least share of the square of the error that is worth telling.
constexpr double kLeastShare = 0.25;

/// Returns each pixel's part of ImageError::noise2, which is their sum.
std::vector<double> noise_by_pixel(const Film& film)
{
    const ChannelReader reader(film);
    const Batches& batches = reader.wide();
    const double channels = 3 * static_cast<double>(film.pixel_count());
    const double scale =
        1 / ((static_cast<double>(batches.batch.size()) - 1) * batches.all * channels);
    std::vector<double> out(film.pixel_count(), 0.0);
    for (std::size_t pixel = 0; pixel < out.size(); ++pixel)
        for (std::size_t channel = 0; channel < 3; ++channel)
            out[pixel] += scale * reader.read(pixel, channel).noise;
    return out;
}

} // namespace

std::optional<Fireflies> find_fireflies(const Film& film, const ImageError& error)
{
    const std::size_t pixels = film.pixel_count();
    const std::size_t most = std::max(kLeastFireflies, pixels / kPixelsPerFirefly);
    if (pixels < kLeastOthers * most || !(error.error > 0))
        return std::nullopt;
    std::vector<double> noise = noise_by_pixel(film);
    const auto others = noise.begin() + static_cast<std::ptrdiff_t>(most);
    std::nth_element(noise.begin(), others, noise.end(), std::greater<>());
    const double rest = std::accumulate(others, noise.end(), 0.0);
    const double bright = kBright * rest / static_cast<double>(pixels - most);
    Fireflies out;
    double carried = 0, kept = rest;
    for (auto one = noise.begin(); one != others; ++one) {
        const bool is_firefly = *one > bright;
        out.pixels += is_firefly ? 1 : 0;
        (is_firefly ? carried : kept) += *one;
    }
    out.share = carried / (error.error * error.error);
    if (out.share < kLeastShare)
        return std::nullopt;
    const double all = static_cast<double>(pixels), left = all - static_cast<double>(out.pixels);
    out.error_without = std::sqrt(kept * all / left + std::max(error.bias2, 0.0) + error.clamp2);
    return out;
}

} // namespace hipmap
