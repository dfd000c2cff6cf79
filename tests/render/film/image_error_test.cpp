#include "render/film/error_cost.h"
#include "render/film/image_error.h"
#include "tests/render/film/film_tile.h"
#include "tests/render/film/synthetic_passes.h"
#include "tests/support/statistics.h"

#include <catch2/catch.hpp>
#include <tbb/global_control.h>

using namespace hipmap;

namespace {

Film film_of(const SyntheticPasses& passes, std::uint64_t first, std::uint64_t end)
{
    Film film = make_film(passes.side, passes.side, 1,
                          passes.radii ? BiasKnowledge::from_radii : BiasKnowledge::unbiased);
    for (std::uint64_t pass = first; pass < end; ++pass)
        add_pass(film, pass, passes.pass(pass));
    return film;
}

SyntheticPasses plain_noise(int block, double photon_noise, double pixel_noise)
{
    SyntheticPasses passes;
    passes.block = block;
    passes.photon_noise = photon_noise;
    passes.pixel_noise = pixel_noise;
    passes.radii = false;
    return passes;
}

SyntheticPasses with_bias(int block, double bias, double order)
{
    SyntheticPasses passes;
    passes.block = block;
    passes.pixel_noise = 0.2;
    passes.bias = bias;
    passes.order = order;
    return passes;
}

/// What a pass of SyntheticPasses loses to clamping: a twentieth of it, every other pass.
PassImages clamped_pass(const SyntheticPasses& passes, std::uint64_t number)
{
    constexpr float kShare = 0.05f;
    PassImages out = passes.pass(number);
    out.cut = Image(passes.side, passes.side);
    for (std::size_t i = 0; i < out.cut.pixels.size(); ++i) {
        const int x = static_cast<int>(i) % passes.side, y = static_cast<int>(i) / passes.side;
        const bool hit = (number / kBatches + number + i) % 2 == 0;
        out.cut.pixels[i] = hit ? 2 * kShare * passes.truth(x, y) : Rgb(0);
        out.radiance.pixels[i] -= out.cut.pixels[i];
    }
    return out;
}

/// Standard errors between a share of `n` and `share`.
double binomial_z(int found, int n, double share)
{
    return (found - n * share) / std::sqrt(n * share * (1 - share));
}

/// What an image's error is to what is told.
struct Coverage {
    int runs = 0;
    int inside = 0;
    RunningMean width; ///< of the interval, relative to the error

    void add(const ImageError& told, double truth)
    {
        ++runs;
        inside += truth >= told.low && truth <= told.high ? 1 : 0;
        width.add((told.high - told.low) / told.error);
    }
    /// 95 % of the images, give or take what the approximations may cost, and no more.
    bool right() const
    {
        return binomial_z(inside, runs, 0.92) > -kMostZ && binomial_z(inside, runs, 0.98) < kMostZ;
    }
};

} // namespace

TEST_CASE("image error: the same at any number of threads", "[film]")
{
    SyntheticPasses passes = with_bias(4, 0.1, 2);
    passes.side = 160;
    REQUIRE(passes.side * passes.side > 4 * static_cast<int>(kPixelsOfTask));
    std::vector<Film> films;
    std::vector<ImageError> errors;
    for (const std::size_t threads : {1, 2, 7}) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        films.push_back(film_of(passes, 0, 5));
        errors.push_back(estimate_error(films.back()).value());
    }
    for (std::size_t i = 1; i < films.size(); ++i) {
        CHECK(films[i] == films[0]);
        CHECK(film_image(films[i]).pixels == film_image(films[0]).pixels);
        CHECK(errors[i] == errors[0]);
    }
}

TEST_CASE("image error: 95 % intervals hold the true error of 95 % of the images", "[film]")
{
    constexpr std::uint64_t kPasses[] = {4, 6, 8, 19};
    struct Case {
        SyntheticPasses passes;
        double widest;
    };
    // The more pixels share photons, the less an image knows of its own error.
    for (Case test : {Case{plain_noise(4, 0, 0.3), 0.3}, Case{plain_noise(4, 0.3, 0.1), 0.6},
                      Case{plain_noise(24, 0.3, 0), 3}, Case{with_bias(4, 0, 2), 3},
                      Case{with_bias(4, 0.2, 1), 3}, Case{with_bias(4, 0.2, 2), 3}}) {
        const Image truth = test.passes.truth();
        Coverage coverage;
        for (test.passes.seed = 0; test.passes.seed < 150; ++test.passes.seed) {
            const Film film = film_of(test.passes, 0, kPasses[test.passes.seed % 4]);
            coverage.add(*estimate_error(film), true_error(film_image(film), truth));
        }
        INFO("block " << test.passes.block << ", bias " << test.passes.bias << ", order "
                      << test.passes.order << ": " << coverage.inside << " of " << coverage.runs
                      << ", width " << coverage.width.mean());
        CHECK(coverage.right());
        CHECK(coverage.width.mean() < test.widest);
    }
}

TEST_CASE("image error: intervals hold for runs that are stopped at an error", "[film]")
{
    struct Case {
        SyntheticPasses passes;
        double target;
        double least; ///< passes on average
    };
    for (auto [passes, target, least] :
         {Case{plain_noise(4, 0.3, 0.1), 0.1, 10}, Case{plain_noise(4, 0.3, 0.1), 0.16, 4},
          Case{with_bias(4, 0.2, 1.5), 0.15, 10}}) {
        const Image truth = passes.truth();
        Coverage coverage;
        RunningMean stopped_at;
        for (passes.seed = 0; passes.seed < 150; ++passes.seed) {
            Film film = film_of(passes, 0, 0);
            std::optional<ImageError> error;
            std::uint64_t pass = 0;
            for (; !error || error->error > target; error = estimate_error(film))
                for (const std::uint64_t check = next_check(pass); pass < check; ++pass)
                    add_pass(film, pass, passes.pass(pass));
            coverage.add(*error, true_error(film_image(film), truth));
            stopped_at.add(static_cast<double>(pass));
        }
        INFO(coverage.inside << " of " << coverage.runs << " at " << stopped_at.mean());
        CHECK(coverage.right());
        CHECK(stopped_at.standard_error() > 0); // luck had a say
        CHECK(stopped_at.mean() > least);
    }
}

TEST_CASE("image error: the noise told is right on average, whatever pixels share", "[film]")
{
    SyntheticPasses rarely_bright = plain_noise(4, 0, 0.5);
    rarely_bright.rare = 0.02;
    for (SyntheticPasses passes :
         {plain_noise(4, 0, 0.2), plain_noise(8, 0.15, 0.1), rarely_bright}) {
        const Image truth = passes.truth();
        RunningMean off;
        for (passes.seed = 0; passes.seed < 100; ++passes.seed) {
            const Film film = film_of(passes, 3, 16); // batches of unequal size
            const double error = true_error(film_image(film), truth);
            off.add(estimate_error(film)->noise2 - error * error);
        }
        const double error = true_error(film_image(film_of(passes, 3, 16)), truth);
        INFO("off by " << off.mean() / (error * error) << " +- "
                       << off.standard_error() / (error * error));
        // Denominators are estimates too, which is of second order in the noise.
        CHECK(std::abs(off.mean()) < kMostZ * off.standard_error() + 0.02 * error * error);
        CHECK(off.standard_error() < 0.1 * error * error);
    }
}

TEST_CASE("image error: it is right where tiles hold more passes than others", "[film]")
{
    SyntheticPasses biased = with_bias(2, 0.2, 2);
    biased.photon_noise = 0.02;
    for (SyntheticPasses passes : {plain_noise(4, 0.1, 0.2), biased}) {
        const Image truth = passes.truth();
        const int side = passes.side;
        RunningMean off, of_noise;
        for (passes.seed = 0; passes.seed < 60; ++passes.seed) {
            Film film = film_of(passes, 0, 0);
            merge_film(film, film_tile(film_of(passes, 0, 6), {0, 0, side / 2, side}));
            merge_film(film, film_tile(film_of(passes, 0, 40), {side / 2, 0, side, side}));
            const double error = true_error(film_image(film), truth);
            const ImageError told = *estimate_error(film);
            off.add((told.noise2 + told.bias2) / (error * error) - 1);
            of_noise.add(told.noise2 / (error * error));
        }
        INFO("off by " << off.mean() << " +- " << off.standard_error() << ", noise "
                       << of_noise.mean());
        // Weights and the clamp of the order make the bias told a little too large.
        CHECK(std::abs(off.mean()) <
              kMostZ * off.standard_error() + (passes.bias > 0 ? 0.1 : 0.02));
        CHECK(off.standard_error() < 0.05);
    }
}

TEST_CASE("image error: pixels that no pass holds do not count", "[film]")
{
    const SyntheticPasses passes = plain_noise(4, 0.1, 0.2);
    const int side = passes.side;
    const Film whole = film_of(passes, 0, 16);
    const PixelRect half = {0, 0, side, side / 2};
    Film film = film_of(passes, 0, 0);
    CHECK_FALSE(estimate_error(film));
    merge_film(film, film_tile(whole, half));
    const ImageError told = *estimate_error(film), own = *estimate_error(film_tile(whole, half));
    CHECK(told.noise2 == Approx(own.noise2).epsilon(0.01)); // its border has other neighbours
    CHECK(told.high == Approx(own.high).epsilon(0.01));
    Film single = film_of(passes, 0, 0);
    merge_film(single, film_tile(film_of(passes, 3, 4), half));
    CHECK_FALSE(estimate_error(single));
}

TEST_CASE("image error: bias of orders 1 and 2 is found from the radii", "[film]")
{
    for (const double order : {1.0, 2.0}) {
        SyntheticPasses passes = with_bias(2, 0.1, order);
        passes.photon_noise = 0.02;
        passes.pixel_noise = 0.2;
        constexpr std::uint64_t kPasses = 24;
        SyntheticPasses exact = passes;
        exact.photon_noise = exact.pixel_noise = 0;
        const double truth = true_error(film_image(film_of(exact, 0, kPasses)), passes.truth());
        RunningMean found, fitted;
        for (passes.seed = 0; passes.seed < 40; ++passes.seed) {
            const ImageError error = *estimate_error(film_of(passes, 0, kPasses));
            found.add(error.bias2 / (truth * truth));
            fitted.add(error.order);
        }
        INFO("order " << order << ", found " << fitted.mean() << ", bias " << found.mean());
        // What the third radius leaves is taken for half-way between this order and 2, and the
        // order is kept within 1 and 2, which is a small bias of its own.
        const double ratio = std::pow(kNarrowing, order), middle = (ratio + 0.5) / 2;
        const double left = ratio / (1 - middle);
        const double expected = std::pow((1 + left) * (1 - ratio), 2);
        const double told_order = std::log(left / (1 + left)) / std::log(kNarrowing);
        CHECK(fitted.mean() == Approx(told_order).margin(0.1));
        CHECK(found.mean() == Approx(expected).margin(0.1 + kMostZ * found.standard_error()));
        CHECK(found.standard_error() < 0.03);
    }
}

TEST_CASE("image error: the part of the noise that photons make is told from the radii", "[film]")
{
    const auto [photon_noise, pixel_noise] =
        GENERATE(std::pair{0.3, 0.0}, std::pair{0.3, 0.3}, std::pair{0.0, 0.3});
    SyntheticPasses passes;
    passes.photon_noise = photon_noise;
    passes.pixel_noise = pixel_noise;
    constexpr std::uint64_t kPasses = 16;
    double photons = 0, pixels = 0; // variances, summed over the passes
    for (std::uint64_t pass = 0; pass < kPasses; ++pass) {
        photons += std::pow(photon_noise / radius_of_pass(pass, 2.0 / 3), 2);
        pixels += pixel_noise * pixel_noise;
    }
    RunningMean found;
    for (passes.seed = 0; passes.seed < 50; ++passes.seed) {
        const ImageError error = *estimate_error(film_of(passes, 0, kPasses));
        found.add(error.photon2 / error.noise2);
    }
    CHECK(found.mean() == Approx(photons / (photons + pixels)).epsilon(0.1));
    CHECK(found.standard_error() < 0.02);
}

TEST_CASE("image error: where there is no bias its square is as often below zero", "[film]")
{
    SyntheticPasses passes = with_bias(4, 0, 1);
    int below = 0, runs = 0;
    RunningMean square;
    for (passes.seed = 0; passes.seed < 150; ++passes.seed, ++runs) {
        const ImageError error = *estimate_error(film_of(passes, 0, 8));
        below += error.bias2 < 0 ? 1 : 0;
        square.add(error.bias2);
        CHECK(error.low >= 0);
        CHECK(error.error >= error.low);
        CHECK(error.high >= error.error);
        CHECK(error.error >= std::sqrt(error.noise2) * (1 - 1e-9));
    }
    CHECK(std::abs(binomial_z(below, runs, 0.55)) < kMostZ);
    CHECK(below < runs);
}

TEST_CASE("image error: little is claimed of few passes, none of black ones", "[film]")
{
    const SyntheticPasses passes = plain_noise(4, 0.1, 0.1);
    CHECK_FALSE(estimate_error(film_of(passes, 0, 0)));
    CHECK_FALSE(estimate_error(film_of(passes, 0, 1)));
    CHECK_FALSE(estimate_error(make_film(2, 2, 1, BiasKnowledge::from_radii)));
    CHECK(std::isinf(estimate_error(film_of(passes, 0, 3))->high));
    CHECK(std::isfinite(estimate_error(film_of(passes, 0, 4))->high));

    Film black = make_film(4, 4, 0, BiasKnowledge::from_radii);
    for (std::uint64_t pass = 0; pass < 9; ++pass)
        add_pass(black, pass,
                 {Image(4, 4), Image(4, 4), Image(4, 4), std::vector<std::uint8_t>(16, 1)});
    const ImageError error = *estimate_error(black);
    CHECK(error.error == 0);
    CHECK(error.low == 0);
    CHECK(error.high == 0);
}

TEST_CASE("image error: passes without a sample of a pixel do not count as dark ones", "[film]")
{
    SyntheticPasses passes = plain_noise(4, 0, 0.01);
    Film film = film_of(passes, 0, 0);
    for (std::uint64_t pass = 0; pass < 16; ++pass) {
        PassImages images = passes.pass(pass);
        for (std::size_t i = pass; i < images.kept.size(); i += 7) {
            images.kept[i] = 0;
            images.radiance.pixels[i] = Rgb(-1e9f);
        }
        add_pass(film, pass, images);
    }
    CHECK(estimate_error(film)->error ==
          Approx(estimate_error(film_of(passes, 0, 16))->error).epsilon(0.15));
    CHECK(true_error(film_image(film), passes.truth()) < 0.01);
}

TEST_CASE("image error: layers have the size of what is in them", "[film]")
{
    SyntheticPasses passes = with_bias(4, 0.2, 2);
    passes.photon_noise = 0.02;
    passes.pixel_noise = 0.02;
    const Film film = film_of(passes, 0, 32);
    const ErrorLayers layers = error_layers(film);
    const Image image = film_image(film), truth = passes.truth();
    double off = 0, bias = 0, told = 0, noise = 0, sum = 0;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const double difference = image.pixels[i].x - truth.pixels[i].x;
        off += difference * difference;
        bias += std::pow(layers.bias.pixels[i].x - difference, 2);
        told += std::pow(layers.error.pixels[i].x, 2);
        noise += std::pow(layers.noise.pixels[i].x, 2);
        sum += std::pow(truth.pixels[i].x, 2);
    }
    CHECK(bias < 0.1 * off); // pixel by pixel, with its sign
    CHECK(told == Approx(off).epsilon(0.2));
    // In pass i the photons' part goes with 1 / radius squared, below 4 here.
    CHECK(noise > sum * 0.02 * 0.02 / 32);
    CHECK(noise < sum * 5 * 0.02 * 0.02 / 32);
}

TEST_CASE("image error: where no bias is known, the error of pixels is their noise", "[film]")
{
    const Film film = film_of(plain_noise(4, 0.3, 0.3), 0, 12);
    const ErrorLayers layers = error_layers(film);
    CHECK(layers.bias.pixels.empty());
    CHECK(layers.error.pixels == layers.noise.pixels);
    CHECK(layers.error.pixels[0].x > 0);
}

TEST_CASE("image error: what clamping took is bias, which more passes keep", "[film]")
{
    const SyntheticPasses passes = plain_noise(1, 0, 0.05);
    Film film = make_film(passes.side, passes.side, 1, BiasKnowledge::unbiased, true);
    Film half = film, other = film;
    for (std::uint64_t pass = 0; pass < 64; ++pass) {
        add_pass(film, pass, clamped_pass(passes, pass));
        add_pass(pass % 3 == 0 ? half : other, pass, clamped_pass(passes, pass));
    }
    merge_film(half, other);
    CHECK(half == film);
    const ImageError error = estimate_error(film).value();
    // A twentieth of the truth, less where it is dark.
    CHECK(std::sqrt(error.clamp2) > 0.035);
    CHECK(std::sqrt(error.clamp2) < 0.05);
    CHECK(error.error * error.error ==
          Approx(error.noise2 + std::max(error.bias2, 0.0) + error.clamp2));
    CHECK(error.low > 0.9 * std::sqrt(error.clamp2));
    const std::vector<ErrorCheck> checks = {{64, 1, error}};
    const ErrorLaw law = error_law(checks, 2.0 / 3);
    CHECK(error_after(law, 1e12) == Approx(std::sqrt(error.clamp2)).epsilon(1e-3));
    CHECK(std::isinf(passes_for(law, 0.5 * std::sqrt(error.clamp2))));
}

TEST_CASE("error: values that the film clamped widen the interval by what they may lack", "[film]")
{
    Film film = film_of(plain_noise(1, 0, 0.2), 0, 8);
    const ImageError before = *estimate_error(film);
    film.saturated = 5;
    const ImageError after = *estimate_error(film);
    const double more = 5.0 / (3.0 * static_cast<double>(film.pixel_count()));
    CHECK(after.high * after.high == Approx(before.high * before.high + more));
    CHECK(after.low == before.low);
    CHECK(after.error == before.error);
    film.saturated = std::uint64_t{1} << 60;
    CHECK(estimate_error(film)->high < 2);
}
