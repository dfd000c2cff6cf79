#include "render/film/film.h"

#include <array>
#include <cassert>

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

void add_image(const Image& image, const std::vector<std::uint8_t>& kept, double units,
               std::int64_t* sums, std::uint64_t& saturated)
{
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        if (kept[i] == 0)
            continue;
        assert(is_finite(image.pixels[i]));
        for (int c = 0; c < 3; ++c)
            sums[3 * i + static_cast<std::size_t>(c)] +=
                to_units(image.pixels[i][c], units, saturated);
    }
}

void add_sums(std::vector<std::int64_t>& into, const std::vector<std::int64_t>& from)
{
    assert(into.size() == from.size());
    for (std::size_t i = 0; i < into.size(); ++i)
        into[i] += from[i];
}

} // namespace

std::int64_t largest_value()
{
    return std::int64_t{1} << kValueBits;
}

Film make_film(int width, int height, double mean, BiasKnowledge bias, bool clamped)
{
    Film film;
    film.width = width;
    film.height = height;
    film.bias = bias;
    const bool usable = mean > 0 && std::isfinite(mean);
    film.scale = kMeanBits - (usable ? std::ilogb(mean) : 0);
    film.radiance.resize(kBatches * 3 * film.pixel_count());
    if (bias == BiasKnowledge::from_radii) {
        film.narrow.resize(kNarrowBatches * 3 * film.pixel_count());
        film.narrower.resize(film.narrow.size());
    }
    if (clamped)
        film.cut.resize(kNarrowBatches * 3 * film.pixel_count());
    return film;
}

void add_pass(Film& film, std::uint64_t pass, const PassImages& images)
{
    const std::size_t pixels = film.pixel_count();
    assert(images.radiance.pixels.size() == pixels && images.kept.size() == pixels);
    const double units = std::ldexp(1.0, film.scale);
    const std::uint64_t batch = pass % kBatches;
    add_image(images.radiance, images.kept, units, &film.radiance[batch * 3 * pixels],
              film.saturated);
    if (film.bias == BiasKnowledge::from_radii) {
        assert(images.narrow.pixels.size() == pixels && images.narrower.pixels.size() == pixels);
        const std::size_t first = pass % kNarrowBatches * 3 * pixels;
        add_image(images.narrow, images.kept, units, &film.narrow[first], film.saturated);
        add_image(images.narrower, images.kept, units, &film.narrower[first], film.saturated);
    }
    if (!film.cut.empty()) {
        assert(images.cut.pixels.size() == pixels);
        add_image(images.cut, images.kept, units, &film.cut[pass % kNarrowBatches * 3 * pixels],
                  film.saturated);
    }
    for (std::size_t i = 0; i < pixels; ++i)
        if (images.kept[i] == 0)
            ++film.lost[i * kBatches + batch];
    film.passes = united(film.passes, {{{pass, pass + 1}}});
    assert(count(film.passes) <= kMostPasses);
}

void merge_film(Film& into, const Film& from)
{
    assert(into.width == from.width && into.height == from.height && into.scale == from.scale &&
           into.bias == from.bias);
    into.passes = united(into.passes, from.passes);
    assert(count(into.passes) <= kMostPasses);
    add_sums(into.radiance, from.radiance);
    add_sums(into.narrow, from.narrow);
    add_sums(into.narrower, from.narrower);
    add_sums(into.cut, from.cut);
    for (const auto& [key, passes] : from.lost)
        into.lost[key] += passes;
    into.saturated += from.saturated;
}

std::uint64_t kept_passes(const Film& film, std::uint64_t passes, std::size_t pixel,
                          std::uint64_t batch)
{
    if (film.lost.empty())
        return passes;
    const auto found = film.lost.find(pixel * kBatches + batch);
    return found == film.lost.end() ? passes : passes - found->second;
}

Image film_image(const Film& film)
{
    Image out(film.width, film.height);
    const double unit = std::ldexp(1.0, -film.scale);
    std::array<std::uint64_t, kBatches> passes{};
    for (std::uint64_t batch = 0; batch < kBatches; ++batch)
        passes[batch] = count(film.passes, kBatches, batch);
    for (std::size_t i = 0; i < out.pixels.size(); ++i) {
        std::uint64_t kept = 0;
        std::array<std::int64_t, 3> sum{};
        for (std::uint64_t batch = 0; batch < kBatches; ++batch) {
            kept += kept_passes(film, passes[batch], i, batch);
            for (std::size_t c = 0; c < 3; ++c)
                sum[c] += film.radiance[(batch * out.pixels.size() + i) * 3 + c];
        }
        for (std::size_t c = 0; kept > 0 && c < 3; ++c)
            out.pixels[i][static_cast<int>(c)] =
                static_cast<float>(static_cast<double>(sum[c]) / static_cast<double>(kept) * unit);
    }
    return out;
}

} // namespace hipmap
