#include "render/film/film_difference.h"
#include "tests/render/film/synthetic_passes.h"

#include <catch2/catch.hpp>

namespace hipmap {
namespace {

Film film_without_radii(const SyntheticPasses& passes, std::uint64_t count, double factor = 1)
{
    Film out = make_film(passes.side, passes.side, 1, BiasKnowledge::unknown);
    for (std::uint64_t pass = 0; pass < count; ++pass) {
        PassImages images = passes.pass(pass);
        images.narrow = images.narrower = {};
        for (Rgb& pixel : images.radiance.pixels)
            pixel *= static_cast<float>(factor);
        add_pass(out, pass, images);
    }
    return out;
}

TEST_CASE("film difference: zero for the same film", "[film]")
{
    const Film film = film_without_radii({.radii = false}, 4);
    const FilmDifference found = difference_of(film, film);
    CHECK(found.square == 0);
    CHECK(found.spread == 0);
}

TEST_CASE("film difference: a factor without noise is the difference from one", "[film]")
{
    const SyntheticPasses exact{.photon_noise = 0, .pixel_noise = 0, .radii = false};
    const FilmDifference found =
        difference_of(film_without_radii(exact, 4), film_without_radii(exact, 4, 1.2));
    // Dark pixels count less, docs/error.md (3).
    CHECK(std::sqrt(found.square) ==
          Approx(true_error(film_image(film_without_radii(exact, 4, 1.2)), exact.truth()))
              .epsilon(0.05));
    CHECK(found.spread < 1e-6);
}

TEST_CASE("film difference: noise neither adds to it nor hides it", "[film]")
{
    constexpr int kRuns = 60;
    double equal = 0, other = 0, squares = 0, spreads = 0;
    for (std::uint64_t seed = 0; seed < kRuns; ++seed) {
        const SyntheticPasses first{
            .photon_noise = 0.15, .pixel_noise = 0.15, .seed = seed, .radii = false};
        SyntheticPasses second = first;
        second.seed += kRuns;
        const FilmDifference none =
            difference_of(film_without_radii(first, 4), film_without_radii(second, 4));
        equal += none.square / kRuns;
        squares += none.square * none.square / kRuns;
        spreads += none.spread * none.spread / kRuns;
        other +=
            difference_of(film_without_radii(first, 4), film_without_radii(second, 4, 1.2)).square /
            kRuns;
    }
    const double spread = std::sqrt(squares - equal * equal);
    CHECK(std::abs(equal) < 3 * spread / std::sqrt(kRuns));
    CHECK(std::sqrt(other) == Approx(0.2).epsilon(0.15));
    // The jackknife of four batches is wide, but not by much.
    CHECK(std::sqrt(spreads) > 0.7 * spread);
    CHECK(std::sqrt(spreads) < 2.5 * spread);
}

TEST_CASE("film difference: passes that share their noise differ by less noise", "[film]")
{
    const SyntheticPasses passes{.radii = false}, others{.seed = 1, .radii = false};
    const Film film = film_without_radii(passes, 4);
    CHECK(difference_of(film, film_without_radii(passes, 4, 1.01)).spread <
          0.1 * difference_of(film, film_without_radii(others, 4, 1.01)).spread);
}

TEST_CASE("film difference: unknown with too few passes", "[film]")
{
    const SyntheticPasses passes{.radii = false};
    CHECK(difference_of(film_without_radii(passes, 1), film_without_radii(passes, 1)).square == 0);
    CHECK(std::isinf(
        difference_of(film_without_radii(passes, 2), film_without_radii(passes, 2)).spread));
    CHECK(std::isfinite(
        difference_of(film_without_radii(passes, 3), film_without_radii(passes, 3)).spread));
}

} // namespace
} // namespace hipmap
