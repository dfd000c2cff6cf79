#include "render/film/fireflies.h"

#include "render/film/batch_products.h"
#include "render/film/rare_samples.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace hipmap {

namespace {

/// Which pixels are fireflies, docs/error.md (19), (24).
struct Search {
    std::size_t pixels_each; ///< one pixel of so many may be one
    double bright;           ///< the least ratio of its noise to the mean of those that cannot be
};

/// The message names clear cases only. Removal looks at more pixels and tests each one again.
constexpr Search kTold{1000, 100}, kRemoved{200, 30};

/// Noise that is left of a pixel, over what it had, above which a second batch has found the light
/// too.
constexpr double kSeenAgain = 1.0 / 16;

/// The pixels that one sample counts in by the widest filter; at least so many may be fireflies.
constexpr std::size_t kLeastFireflies = 9;
/// An image with fewer pixels for each of these is too small to tell.
constexpr std::size_t kLeastOthers = 10;
/// The least share of the square of the error that is worth telling.
constexpr double kLeastShare = 0.25;

/// Returns the factor that makes the sum of a pixel's ChannelStatistics::noise its part of
/// ImageError::noise2.
double scale_of_noise(const Film& film, const ChannelReader& reader)
{
    const Batches& batches = reader.wide();
    return 1 / ((static_cast<double>(batches.batch.size()) - 1) * batches.all * 3 *
                static_cast<double>(film.pixel_count()));
}

using PixelStatistics = std::array<ChannelStatistics, 3>;

PixelStatistics read_pixel(const ChannelReader& reader, std::size_t pixel)
{
    return {reader.read(pixel, 0), reader.read(pixel, 1), reader.read(pixel, 2)};
}

double noise_of(const PixelStatistics& pixel)
{
    return pixel[0].noise + pixel[1].noise + pixel[2].noise;
}

/// Returns whether most of the noise comes from batches that are brighter than the mean of all: a
/// dark batch among bright ones is no firefly.
bool is_bright(const PixelStatistics& pixel)
{
    double sum = 0;
    for (const ChannelStatistics& channel : pixel)
        for (const double deviation : channel.deviation)
            sum += channel.steady * deviation * std::abs(deviation);
    return sum > 0;
}

/// Pixels that may be fireflies, and the least noise of one; docs/error.md (19).
struct Candidates {
    std::vector<double> noise;       ///< [pixels] noise_of each
    std::vector<std::size_t> pixels; ///< the noisiest, ascending
    double rest = 0;                 ///< noise of all others
    double bright = 0;               ///< a firefly has more noise
};

/// None: the image is too small to tell.
std::optional<Candidates> find_candidates(const Film& film, const ChannelReader& reader,
                                          const Search& search)
{
    const std::size_t pixels = film.pixel_count();
    const std::size_t most = std::max(kLeastFireflies, pixels / search.pixels_each);
    if (pixels < kLeastOthers * most)
        return std::nullopt;
    Candidates out;
    out.noise.resize(pixels);
    tbb::parallel_for(std::size_t{0}, pixels, [&](std::size_t pixel) {
        out.noise[pixel] = noise_of(read_pixel(reader, pixel));
    });
    std::vector<std::uint32_t> order(pixels);
    std::iota(order.begin(), order.end(), 0u);
    const auto others = order.begin() + static_cast<std::ptrdiff_t>(most);
    std::nth_element(order.begin(), others, order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return out.noise[a] != out.noise[b] ? out.noise[a] > out.noise[b] : a < b;
    });
    out.pixels.assign(order.begin(), others);
    std::ranges::sort(out.pixels);
    std::sort(others, order.end());
    for (auto one = others; one != order.end(); ++one)
        out.rest += out.noise[*one];
    out.bright = search.bright * out.rest / static_cast<double>(pixels - most);
    return out;
}

std::array<std::vector<std::int64_t>*, 3> narrow_sums(Film& film)
{
    return {&film.narrow, &film.narrower, &film.cut};
}

/// Exchanges the sums of a pixel in one batch with `values`.
void exchange(std::vector<std::int64_t>& sums, std::size_t place,
              std::array<std::int64_t, 3>& values)
{
    for (std::size_t channel = 0; channel < 3 && !sums.empty(); ++channel)
        std::swap(sums[place * 3 + channel], values[channel]);
}

void exchange(Film& film, PixelSums& aside)
{
    const std::size_t pixels = film.pixel_count();
    for (PixelSums::Batch& one : aside.wide)
        exchange(film.radiance, one.number * pixels + aside.pixel, one.radiance);
    for (std::size_t i = 0; i < 3; ++i)
        exchange(*narrow_sums(film)[i], aside.narrow_batch * pixels + aside.pixel, aside.narrow[i]);
}

/// Sets the sums of the batches aside that share narrow sums with `batch`, or of it alone where
/// there are none.  kept: of the film.
PixelSums set_aside(Film& film, const KeptPasses& kept, std::size_t pixel, std::uint64_t batch)
{
    PixelSums out;
    out.pixel = pixel;
    out.narrow_batch = batch % kNarrowBatches;
    const bool alone = film.narrow.empty() && film.cut.empty();
    for (std::uint64_t one = 0; one < kBatches; ++one) {
        const auto passes = static_cast<std::uint32_t>(kept.of_batch(pixel, one));
        if (passes == 0 || (alone ? one != batch : one % kNarrowBatches != out.narrow_batch))
            continue;
        std::uint32_t& lost = film.lost[pixel * kBatches + one];
        out.wide.push_back({one, lost});
        lost += passes;
    }
    exchange(film, out);
    return out;
}

void put_back(Film& film, PixelSums aside)
{
    exchange(film, aside);
    for (const PixelSums::Batch& one : aside.wide)
        if (one.lost > 0)
            film.lost[aside.pixel * kBatches + one.number] = one.lost;
        else
            film.lost.erase(aside.pixel * kBatches + one.number);
}

/// Returns the noise after a batch was set aside, with the weights before it was: a darker pixel
/// weighs more.
double noise_left(const PixelStatistics& before, const PixelStatistics& after)
{
    double sum = 0;
    for (std::size_t channel = 0; channel < 3; ++channel)
        if (after[channel].steady > 0)
            sum += after[channel].noise * (before[channel].steady / after[channel].steady);
    return sum;
}

/// Returns the batch that is above the others by most.
std::uint64_t brightest_batch(const ChannelReader& reader, const PixelStatistics& pixel)
{
    std::array<double, kBatches> above{};
    for (const ChannelStatistics& channel : pixel)
        for (std::size_t i = 0; i < kBatches; ++i)
            above[i] += channel.steady * std::max(channel.deviation[i], 0.0) * channel.deviation[i];
    return reader.wide()
        .batch[static_cast<std::size_t>(std::ranges::max_element(above) - above.begin())];
}

/// Returns those candidates whose noise is mostly of one bright batch, or of few; the film stays as
/// it is.
std::vector<OutstandingPixel> find_outstanding(Film& film, const KeptPasses& kept,
                                               const ChannelReader& reader, const Candidates& found)
{
    std::vector<OutstandingPixel> out;
    for (const std::size_t pixel : found.pixels) {
        const double noise = found.noise[pixel];
        const PixelStatistics before = read_pixel(reader, pixel);
        if (!(noise > found.bright) || !is_bright(before))
            continue;
        const std::uint64_t batch = brightest_batch(reader, before);
        PixelSums sums = set_aside(film, kept, pixel, batch);
        const PixelStatistics after = read_pixel(reader, pixel);
        put_back(film, std::move(sums));
        const double left = noise_left(before, after);
        out.push_back({pixel, batch, std::max(noise - left, 0.0),
                       after[0].batches < 2 || left > std::max(found.bright, kSeenAgain * noise)});
    }
    return out;
}

double light_of(const PixelStatistics& pixel)
{
    return pixel[0].mean + pixel[1].mean + pixel[2].mean;
}

double sum_of(const Image& image)
{
    return std::accumulate(
        image.pixels.begin(), image.pixels.end(), 0.0,
        [](double sum, const Rgb& pixel) { return sum + pixel.x + pixel.y + pixel.z; });
}

} // namespace

std::optional<Fireflies> find_fireflies(const Film& film, const ImageError& error)
{
    if (!(error.error > 0))
        return std::nullopt;
    const ChannelReader reader(film);
    const std::optional<Candidates> found = find_candidates(film, reader, kTold);
    if (!found)
        return std::nullopt;
    const double scale = scale_of_noise(film, reader);
    Fireflies out;
    double carried = 0, kept = found->rest;
    for (const std::size_t pixel : found->pixels) {
        const double noise = found->noise[pixel];
        const bool is_firefly = noise > found->bright && is_bright(read_pixel(reader, pixel));
        out.pixels += is_firefly ? 1 : 0;
        (is_firefly ? carried : kept) += noise;
    }
    out.share = scale * carried / (error.error * error.error);
    if (out.share < kLeastShare)
        return std::nullopt;
    const double all = static_cast<double>(film.pixel_count());
    const double left = all - static_cast<double>(out.pixels);
    out.error_without =
        std::sqrt(scale * kept * all / left + std::max(error.bias2, 0.0) + error.clamp2);
    return out;
}

RemovedFireflies remove_fireflies(Film& film, std::vector<PixelSums>* aside)
{
    RemovedFireflies out;
    const double light = sum_of(film_image(film));
    const ChannelReader reader(film);
    if (reader.wide().batch.size() < kFewestBatches || !(light > 0))
        return out;
    const std::optional<Candidates> found = find_candidates(film, reader, kRemoved);
    if (!found)
        return out;
    const KeptPasses kept(film);
    const std::vector<OutstandingPixel> pixels = find_outstanding(film, kept, reader, *found);
    const RareSamples rare = judge_rare_samples(pixels, static_cast<std::size_t>(film.width));
    if (aside != nullptr)
        aside->reserve(pixels.size()); // nothing may fail while sums are neither here nor there
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        if (rare.removed[i] == 0)
            continue;
        const double before = light_of(read_pixel(reader, pixels[i].pixel));
        PixelSums sums = set_aside(film, kept, pixels[i].pixel, pixels[i].batch);
        ++out.pixels;
        out.light += (before - light_of(read_pixel(reader, pixels[i].pixel))) / light;
        if (aside != nullptr)
            aside->push_back(std::move(sums));
    }
    out.bias2 = scale_of_noise(film, reader) * rare.missing;
    out.most2 = scale_of_noise(film, reader) * rare.most_missing;
    return out;
}

HiddenFireflies::HiddenFireflies(FireflyChoice choice, Film& film) : film_(film)
{
    if (choice == FireflyChoice::remove)
        removed_ = remove_fireflies(film, &aside_);
}

HiddenFireflies::~HiddenFireflies()
{
    for (PixelSums& one : aside_)
        put_back(film_, std::move(one));
}

std::optional<ImageError> estimate_error(const Film& film, const RemovedFireflies& removed)
{
    std::optional<ImageError> out = estimate_error(film);
    if (!out)
        return out;
    out->removed2 = removed.bias2;
    out->error = std::sqrt(out->error * out->error + removed.bias2);
    out->high = std::sqrt(out->high * out->high + removed.most2);
    return out;
}

std::optional<ImageError> error_of_shown(FireflyChoice choice, Film& film)
{
    const HiddenFireflies hidden(choice, film);
    return estimate_error(film, hidden.removed());
}

} // namespace hipmap
