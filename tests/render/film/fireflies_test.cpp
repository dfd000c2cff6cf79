#include "render/film/fireflies.h"
#include "tests/render/film/synthetic_passes.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

using namespace hipmap;

namespace {

constexpr std::uint64_t kPasses = 12;

std::size_t bright_pixel(const Film& film, std::size_t i)
{
    return film.pixel_count() - 1 - 11 * i;
}

struct Bright {
    std::size_t pixels;
    float radiance;
    std::vector<std::uint64_t> passes = {3};
    bool radii = false;
};

/// Passes of noise, with a bright sample in each of some pixels of some passes.
Film noisy_film(const Bright& bright)
{
    SyntheticPasses passes;
    passes.radii = bright.radii;
    passes.photon_noise = 0.1;
    Film film = make_film(passes.side, passes.side, 1,
                          bright.radii ? BiasKnowledge::from_radii : BiasKnowledge::unbiased);
    for (std::uint64_t number = 0; number < kPasses; ++number) {
        PassImages images = passes.pass(number);
        const auto brighten = [&](Image& image) {
            for (std::size_t i = 0; i < bright.pixels && !image.pixels.empty(); ++i)
                image.pixels[bright_pixel(film, i)] += Rgb(bright.radiance);
        };
        if (std::ranges::count(bright.passes, number) > 0) {
            brighten(images.radiance);
            brighten(images.narrow);
            brighten(images.narrower);
        }
        add_pass(film, number, images);
    }
    return film;
}

Film noisy_film(std::size_t bright, float radiance)
{
    return noisy_film({.pixels = bright, .radiance = radiance});
}

/// Passes of noise in which some pixels, as far apart as can be, get all of a part of their light
/// by bright samples.  power: of the chance that one is brighter than L, which falls as L^-power,
/// above 1; infinite: all are alike.
Film film_hit_by_few(int pixels, double hits, std::uint64_t seed,
                     double power = std::numeric_limits<double>::infinity())
{
    constexpr float kPart = 0.3f;
    const SyntheticPasses passes{
        .photon_noise = 0.05, .pixel_noise = 0.1, .seed = seed, .radii = false};
    Film film = make_film(passes.side, passes.side, 1, BiasKnowledge::unbiased);
    const auto all = static_cast<int>(film.pixel_count());
    const double chance = hits / kPasses;
    for (std::uint64_t number = 0; number < kPasses; ++number) {
        PassImages images = passes.pass(number);
        for (int i = 0; i < pixels; ++i) {
            const int pixel = i * all / pixels;
            RandomSequence random(seed, RandomStream::pictures, number,
                                  static_cast<std::uint64_t>(pixel));
            const bool hit = random.next() < chance;
            const double bright = std::pow(1 - random.next(), -1 / power) * (1 - 1 / power);
            const double light = hit ? bright / chance : 0;
            images.radiance.pixels[static_cast<std::size_t>(pixel)] +=
                passes.truth(pixel % passes.side, pixel / passes.side) * kPart *
                static_cast<float>(light - 1);
        }
        add_pass(film, number, images);
    }
    return film;
}

std::optional<Fireflies> fireflies_of(const Film& film)
{
    return find_fireflies(film, *estimate_error(film));
}

} // namespace

TEST_CASE("find_fireflies: noise alone has none", "[film]")
{
    CHECK(!fireflies_of(noisy_film(0, 0)));
    CHECK(!fireflies_of(noisy_film(5, 1)));
}

TEST_CASE("find_fireflies: pixels with one bright sample carry most of the error", "[film]")
{
    const double plain = estimate_error(noisy_film(0, 0))->error;
    for (const std::size_t bright : {1, 5, 9}) {
        const Film film = noisy_film(bright, 100);
        const ImageError error = *estimate_error(film);
        const std::optional<Fireflies> found = find_fireflies(film, error);
        REQUIRE(found);
        CHECK(found->pixels == bright);
        CHECK(found->share > 0.8);
        CHECK(found->share <= 1);
        CHECK(error.error > 2 * plain);
        CHECK(found->error_without == Approx(plain).epsilon(0.2)); // the mean of (3) is brighter
    }
}

TEST_CASE("find_fireflies: a dark batch among bright ones is none", "[film]")
{
    Film film = noisy_film(5, -100);
    CHECK(!fireflies_of(film));
    CHECK(remove_fireflies(film).pixels == 0);
}

TEST_CASE("find_fireflies: more than a handful of bright pixels are the image's noise", "[film]")
{
    CHECK(!fireflies_of(noisy_film(48, 100)));
}

TEST_CASE("find_fireflies: an image of few pixels has none", "[film]")
{
    Film film = make_film(8, 8, 1, BiasKnowledge::unbiased);
    for (std::uint64_t number = 0; number < 2; ++number) {
        PassImages images{Image(8, 8), {}, {}, std::vector<std::uint8_t>(64, 1)};
        images.radiance.pixels[5] = Rgb(number == 0 ? 100.0f : 0.0f);
        add_pass(film, number, images);
    }
    CHECK(!fireflies_of(film));
}

TEST_CASE("remove_fireflies: what one pass found leaves its pixels, and the error", "[film]")
{
    for (const bool radii : {false, true}) {
        const Film plain = noisy_film({.pixels = 0, .radiance = 0, .radii = radii});
        Film film = noisy_film({.pixels = 5, .radiance = 100, .radii = radii});
        const Image before = film_image(film);
        const double error = estimate_error(film)->error;
        const RemovedFireflies removed = remove_fireflies(film);
        CHECK(removed.pixels == 5);
        const Image after = film_image(film), right = film_image(plain);
        double light = 0, all = 0;
        for (std::size_t i = 0; i < film.pixel_count(); ++i) {
            const bool was_bright = before.pixels[i].x > right.pixels[i].x + 1;
            CHECK((after.pixels[i] == before.pixels[i]) == !was_bright);
            CHECK(std::abs(after.pixels[i].x - right.pixels[i].x) < 0.5f);
            for (int c = 0; c < 3; ++c) {
                light += before.pixels[i][c] - after.pixels[i][c];
                all += before.pixels[i][c];
            }
        }
        CHECK(removed.light == Approx(light / all).epsilon(0.02));
        const ImageError left = *estimate_error(film, removed);
        CHECK(std::sqrt(left.noise2) ==
              Approx(std::sqrt(estimate_error(plain)->noise2)).epsilon(0.1));
        CHECK(left.removed2 == removed.bias2);
        CHECK(left.error < 1.001 * error); // five are too few to be sure that they are rare
        CHECK(left.error * left.error ==
              Approx(left.noise2 + std::max(left.bias2, 0.0) + left.removed2));
    }
}

TEST_CASE("error_of_shown: that of a film without fireflies, which stays", "[film]")
{
    for (const bool radii : {false, true}) {
        const Film film = noisy_film({.pixels = 5, .radiance = 100, .radii = radii});
        Film shown = film, left = film;
        CHECK(error_of_shown(FireflyChoice::keep, shown) == estimate_error(film));
        const RemovedFireflies removed = remove_fireflies(left);
        CHECK(error_of_shown(FireflyChoice::remove, shown) == estimate_error(left, removed));
        CHECK(shown == film);
        {
            const HiddenFireflies hidden(FireflyChoice::remove, shown);
            CHECK(hidden.removed().pixels == 5);
            CHECK(shown == left);
        }
        CHECK(shown == film);
    }
}

TEST_CASE("remove_fireflies: what two batches found stays", "[film]")
{
    const Film film = noisy_film({.pixels = 5, .radiance = 100, .passes = {3, 6}});
    Film left = film;
    CHECK(remove_fireflies(left).pixels == 0);
    CHECK(left == film);
    // Passes 3 and 11 are of one batch.
    Film same_batch = noisy_film({.pixels = 5, .radiance = 100, .passes = {3, 11}});
    CHECK(remove_fireflies(same_batch).pixels == 5);
}

TEST_CASE("remove_fireflies: a weaker second sample does not keep a bright one", "[film]")
{
    Film film = noisy_film({.pixels = 5, .radiance = 100});
    const SyntheticPasses passes{.photon_noise = 0.1, .radii = false};
    PassImages images = passes.pass(kPasses);
    for (std::size_t i = 0; i < 5; ++i)
        images.radiance.pixels[bright_pixel(film, i)] += Rgb(8.0f);
    add_pass(film, kPasses, images);
    CHECK(remove_fireflies(film).pixels == 5);
    CHECK(film_image(film).pixels[bright_pixel(film, 0)].x < 3);
}

TEST_CASE("remove_fireflies: noise, few passes and black images stay as they are", "[film]")
{
    const auto stays = [](const Film& film) {
        Film left = film;
        return remove_fireflies(left).pixels == 0 && left == film;
    };
    CHECK(stays(noisy_film(0, 0)));
    CHECK(stays(noisy_film(5, 0.5f)));
    const SyntheticPasses passes{.radii = false};
    CHECK(stays(make_film(passes.side, passes.side, 1, BiasKnowledge::unbiased)));
    Film few = make_film(passes.side, passes.side, 1, BiasKnowledge::unbiased);
    for (std::uint64_t number = 0; number + 1 < kFewestBatches; ++number) {
        PassImages images = passes.pass(number);
        images.radiance.pixels[7] += Rgb(number == 0 ? 100.0f : 0.0f);
        add_pass(few, number, images);
    }
    CHECK(stays(few));
}

TEST_CASE("error_of_shown: intervals hold where rare samples hit few pixels, once or more",
          "[film]")
{
    struct Case {
        int pixels;
        double hits; ///< expected, of each of these pixels
    };
    constexpr int kRuns = 100;
    for (const auto& [pixels, hits] : {Case{40, 0.2}, Case{12, 1.0}}) {
        int inside = 0;
        double stated2 = 0, true2 = 0;
        for (std::uint64_t seed = 0; seed < kRuns; ++seed) {
            Film film = film_hit_by_few(pixels, hits, seed);
            const ImageError error = *error_of_shown(FireflyChoice::remove, film);
            remove_fireflies(film);
            const double truth = true_error(film_image(film), SyntheticPasses{}.truth());
            inside += truth >= error.low && truth <= error.high ? 1 : 0;
            stated2 += error.error * error.error;
            true2 += truth * truth;
        }
        INFO(pixels << " pixels: " << inside << " inside, stated " << stated2 << ", true "
                    << true2);
        CHECK(inside > 0.75 * kRuns);
        CHECK(stated2 > 0.7 * true2);
        CHECK(stated2 < 1.5 * true2);
    }
}

TEST_CASE("error_of_shown: intervals hold where rare samples differ in brightness", "[film]")
{
    constexpr int kRuns = 200;
    int inside = 0, better = 0, worse = 0;
    std::vector<double> stated;
    for (std::uint64_t seed = 0; seed < kRuns; ++seed) {
        Film film = film_hit_by_few(40, 0.4, seed, 1.5);
        const ImageError error = *error_of_shown(FireflyChoice::remove, film);
        const double kept = true_error(film_image(film), SyntheticPasses{}.truth());
        remove_fireflies(film);
        const double truth = true_error(film_image(film), SyntheticPasses{}.truth());
        inside += truth >= error.low && truth <= error.high ? 1 : 0;
        better += truth < 0.8 * kept ? 1 : 0;
        worse += truth > 1.25 * kept ? 1 : 0;
        stated.push_back(error.error / truth);
    }
    std::ranges::sort(stated);
    INFO(inside << " inside, " << better << " better, " << worse << " worse, stated over true "
                << stated[kRuns / 2]);
    CHECK(inside > 0.87 * kRuns);
    CHECK(better > 0.4 * kRuns);
    CHECK(worse == 0);
    CHECK(stated[kRuns / 2] > 0.9);
    CHECK(stated[kRuns / 2] < 1.15);
}
