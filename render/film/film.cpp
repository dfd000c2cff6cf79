#include "render/film/film.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cassert>
#include <functional>

namespace hipmap {

namespace {

/// A channel as bright as the mean has as many bits as a float.
constexpr int kMeanBits = 24;
/// With 2^20 passes in the film a sum has 62 bits.
constexpr int kValueBits = 42;
static_assert((kMostPasses << kValueBits) <= std::uint64_t{1} << 62);

/// Rounds to the nearest unit, beyond the largest to that.
std::int64_t to_units(float value, double units, std::uint64_t& saturated)
{
    const auto most = static_cast<double>(largest_value());
    const double scaled = static_cast<double>(value) * units;
    if (std::abs(scaled) > most) {
        ++saturated;
        return static_cast<std::int64_t>(std::copysign(most, scaled));
    }
    return std::llrint(scaled);
}

/// Returns how many values were beyond the largest.
std::uint64_t add_image(const Image& image, const std::vector<std::uint8_t>& kept, double units,
                        std::int64_t* sums)
{
    const auto add = [&](const tbb::blocked_range<std::size_t>& pixels, std::uint64_t saturated) {
        for (std::size_t i = pixels.begin(); i < pixels.end(); ++i) {
            if (kept[i] == 0)
                continue;
            assert(is_finite(image.pixels[i]));
            for (int c = 0; c < 3; ++c)
                sums[3 * i + static_cast<std::size_t>(c)] +=
                    to_units(image.pixels[i][c], units, saturated);
        }
        return saturated;
    };
    return tbb::parallel_reduce(
        tbb::blocked_range<std::size_t>(0, image.pixels.size(), kPixelsOfTask), std::uint64_t{0},
        add, std::plus<>());
}

/// Adds the sums of `from`, whose first pixel is at x, y of `into`.  batches: of the sums.
void add_sums(const Film& into, std::vector<std::int64_t>& sums, const Film& from,
              const std::vector<std::int64_t>& added, const ImagePlace& at)
{
    const std::size_t batches = added.size() / (3 * from.pixel_count());
    assert(sums.size() == batches * 3 * into.pixel_count());
    const std::size_t row = 3 * static_cast<std::size_t>(from.width);
    tbb::parallel_for(std::size_t{0}, batches * from.height, [&](std::size_t i) {
        const std::size_t batch = i / from.height, y = i % from.height;
        const std::size_t first = batch * into.pixel_count() + (at.y + y) * into.width + at.x;
        const auto line = added.begin() + static_cast<std::ptrdiff_t>(i * row);
        std::transform(line, line + static_cast<std::ptrdiff_t>(row),
                       sums.begin() + static_cast<std::ptrdiff_t>(3 * first),
                       sums.begin() + static_cast<std::ptrdiff_t>(3 * first), std::plus<>());
    });
}

void add_lost(Film& into, const Film& from, const ImagePlace& at)
{
    for (const auto& [key, passes] : from.lost) {
        const std::uint64_t pixel = key / kBatches;
        const std::uint64_t x = pixel % from.width + at.x, y = pixel / from.width + at.y;
        into.lost[(y * into.width + x) * kBatches + key % kBatches] += passes;
    }
}

/// Sets what the pixels hold.
void set_parts(Film& film, std::vector<FilmPart> parts)
{
    film.passes = {};
    for (const FilmPart& part : parts)
        film.passes = united(film.passes, part.passes);
    const bool same =
        parts.size() == 1 && parts[0].pixels == PixelRect{0, 0, film.width, film.height};
    film.parts = same ? std::vector<FilmPart>() : std::move(parts);
}

std::array<std::uint64_t, kBatches> by_batch(const PassSet& passes)
{
    std::array<std::uint64_t, kBatches> out{};
    for (std::uint64_t batch = 0; batch < kBatches; ++batch)
        out[batch] = count(passes, kBatches, batch);
    return out;
}

} // namespace

std::int64_t largest_value()
{
    return std::int64_t{1} << kValueBits;
}

int film_scale(double mean)
{
    const bool usable = mean > 0 && std::isfinite(mean);
    return kMeanBits - (usable ? std::ilogb(mean) : 0);
}

Film make_film(int width, int height, double mean, BiasKnowledge bias, bool clamped)
{
    Film film;
    film.width = width;
    film.height = height;
    film.bias = bias;
    film.scale = film_scale(mean);
    film.radiance.resize(kBatches * 3 * film.pixel_count());
    if (bias == BiasKnowledge::from_radii) {
        film.narrow.resize(kNarrowBatches * 3 * film.pixel_count());
        film.narrower.resize(film.narrow.size());
    }
    if (clamped)
        film.cut.resize(kNarrowBatches * 3 * film.pixel_count());
    return film;
}

Film empty_like(const Film& film, int width, int height)
{
    Film out = make_film(width, height, 1, film.bias, !film.cut.empty());
    out.place = film.place;
    out.scale = film.scale;
    out.allocation = film.allocation;
    out.expected = film.expected;
    return out;
}

void add_pass(Film& film, std::uint64_t pass, const PassImages& images)
{
    const std::size_t pixels = film.pixel_count();
    assert(images.radiance.pixels.size() == pixels && images.kept.size() == pixels);
    assert(film.parts.empty() && !common_pass(film.passes, {{{pass, pass + 1}}}));
    const double units = std::ldexp(1.0, film.scale);
    const std::uint64_t batch = pass % kBatches;
    film.saturated +=
        add_image(images.radiance, images.kept, units, &film.radiance[batch * 3 * pixels]);
    if (film.bias == BiasKnowledge::from_radii) {
        assert(images.narrow.pixels.size() == pixels && images.narrower.pixels.size() == pixels);
        const std::size_t first = pass % kNarrowBatches * 3 * pixels;
        film.saturated += add_image(images.narrow, images.kept, units, &film.narrow[first]);
        film.saturated += add_image(images.narrower, images.kept, units, &film.narrower[first]);
    }
    if (!film.cut.empty()) {
        assert(images.cut.pixels.size() == pixels);
        film.saturated += add_image(images.cut, images.kept, units,
                                    &film.cut[pass % kNarrowBatches * 3 * pixels]);
    }
    for (std::size_t i = 0; i < pixels; ++i)
        if (images.kept[i] == 0)
            ++film.lost[i * kBatches + batch];
    film.passes = united(film.passes, {{{pass, pass + 1}}});
    assert(count(film.passes) <= kMostPasses);
}

PixelRect pixels_of(const Film& film)
{
    const ImagePlace& at = film.place;
    return {at.x, at.y, at.x + film.width, at.y + film.height};
}

std::vector<FilmPart> parts_of(const Film& film)
{
    if (!film.parts.empty() || film.passes.ranges.empty())
        return film.parts;
    return {{{0, 0, film.width, film.height}, film.passes}};
}

std::vector<FilmPart> moved(std::vector<FilmPart> parts, int x, int y)
{
    for (FilmPart& part : parts) {
        const PixelRect& pixels = part.pixels;
        part.pixels = {pixels.x0 + x, pixels.y0 + y, pixels.x1 + x, pixels.y1 + y};
    }
    return parts;
}

void merge_film(Film& into, const Film& from)
{
    assert(into.scale == from.scale && into.bias == from.bias);
    const ImagePlace at = {from.place.x - into.place.x, from.place.y - into.place.y, 0, 0};
    assert(at.x >= 0 && at.y >= 0 && at.x + from.width <= into.width &&
           at.y + from.height <= into.height);
    std::vector<FilmPart> parts = parts_of(into), more = moved(parts_of(from), at.x, at.y);
    assert(!common_pass(parts, more));
    parts.insert(parts.end(), more.begin(), more.end());
    set_parts(into, joined_parts(parts));
    assert(count(into.passes) <= kMostPasses);
    add_sums(into, into.radiance, from, from.radiance, at);
    add_sums(into, into.narrow, from, from.narrow, at);
    add_sums(into, into.narrower, from, from.narrower, at);
    add_sums(into, into.cut, from, from.cut, at);
    add_lost(into, from, at);
    into.saturated += from.saturated;
}

KeptPasses::KeptPasses(const Film& film) : film_(film)
{
    held_.push_back({});
    if (film.parts.empty()) {
        held_.push_back(by_batch(film.passes));
        return;
    }
    part_of_.assign(film.pixel_count(), 0);
    for (const FilmPart& part : film.parts) {
        assert(held_.size() <= kMostFilmParts);
        for (int y = part.pixels.y0; y < part.pixels.y1; ++y) {
            const auto row = part_of_.begin() + static_cast<std::ptrdiff_t>(y) * film.width;
            std::fill(row + part.pixels.x0, row + part.pixels.x1,
                      static_cast<std::uint16_t>(held_.size()));
        }
        held_.push_back(by_batch(part.passes));
    }
}

std::uint64_t KeptPasses::of_batch(std::size_t pixel, std::uint64_t batch) const
{
    const std::uint64_t held = (part_of_.empty() ? held_.back() : held_[part_of_[pixel]])[batch];
    if (film_.lost.empty())
        return held;
    const auto found = film_.lost.find(pixel * kBatches + batch);
    return found == film_.lost.end() ? held : held - found->second;
}

Image film_image(const Film& film)
{
    Image out(film.width, film.height);
    const double unit = std::ldexp(1.0, -film.scale);
    const KeptPasses kept_passes(film);
    tbb::parallel_for(std::size_t{0}, out.pixels.size(), [&](std::size_t i) {
        std::uint64_t kept = 0;
        std::array<std::int64_t, 3> sum{};
        for (std::uint64_t batch = 0; batch < kBatches; ++batch) {
            const std::uint64_t of_batch = kept_passes.of_batch(i, batch);
            if (of_batch == 0)
                continue; // its sums are zero
            kept += of_batch;
            for (std::size_t c = 0; c < 3; ++c)
                sum[c] += film.radiance[(batch * out.pixels.size() + i) * 3 + c];
        }
        for (std::size_t c = 0; kept > 0 && c < 3; ++c)
            out.pixels[i][static_cast<int>(c)] =
                static_cast<float>(static_cast<double>(sum[c]) / static_cast<double>(kept) * unit);
    });
    return out;
}

} // namespace hipmap
