#include "render/film/fireflies.h"
#include "tests/render/film/synthetic_passes.h"

#include <catch2/catch.hpp>

using namespace hipmap;

namespace {

constexpr std::uint64_t kPasses = 12;

/// Passes of noise, with a bright sample in each of `bright` pixels of one pass.
Film noisy_film(std::size_t bright, float radiance)
{
    SyntheticPasses passes;
    passes.radii = false;
    passes.photon_noise = 0.1;
    Film film = make_film(passes.side, passes.side, 1, BiasKnowledge::unbiased);
    for (std::uint64_t number = 0; number < kPasses; ++number) {
        PassImages images = passes.pass(number);
        for (std::size_t i = 0; number == 3 && i < bright; ++i)
            images.radiance.pixels[images.radiance.pixels.size() - 1 - 11 * i] += Rgb(radiance);
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
