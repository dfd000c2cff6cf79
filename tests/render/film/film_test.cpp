#include "render/film/film.h"
#include "tests/render/film/film_tile.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <limits>
#include <numeric>
#include <random>

using namespace hipmap;

namespace {

constexpr int kWidth = 5, kHeight = 3;

/// Noise of many sizes, now and then a pixel without a sample.
PassImages wild_pass(std::uint64_t pass, bool radii)
{
    std::mt19937_64 random(pass);
    std::normal_distribution<float> value(0.0f, 3.0f);
    const auto image = [&] {
        Image out(kWidth, kHeight);
        for (Rgb& pixel : out.pixels)
            pixel = Rgb(std::exp(value(random)), value(random), 1e-3f * value(random));
        return out;
    };
    PassImages out{image(), radii ? image() : Image(), radii ? image() : Image(), {}};
    for (std::size_t i = 0; i < out.radiance.pixels.size(); ++i)
        out.kept.push_back(random() % 5 > 0);
    return out;
}

Film film_of(std::vector<std::uint64_t> passes, bool radii)
{
    Film film =
        make_film(kWidth, kHeight, 2.0, radii ? BiasKnowledge::from_radii : BiasKnowledge::unknown);
    for (const std::uint64_t pass : passes)
        add_pass(film, pass, wild_pass(pass, radii));
    return film;
}

} // namespace

TEST_CASE("film: passes give the same bits in any order of adding and merging", "[film]")
{
    for (const bool radii : {false, true}) {
        std::vector<std::uint64_t> passes(40);
        for (std::uint64_t i = 0; i < passes.size(); ++i)
            passes[i] = i * i % 41 + 41 * (i / 20); // with gaps
        std::sort(passes.begin(), passes.end());
        passes.erase(std::unique(passes.begin(), passes.end()), passes.end());
        const Film straight = film_of(passes, radii);
        CHECK(!straight.lost.empty());
        std::mt19937 random(1);
        for (int round = 0; round < 5; ++round) {
            std::shuffle(passes.begin(), passes.end(), random);
            CHECK(film_of(passes, radii) == straight);
            const auto cut = passes.begin() + 3 + 4 * round;
            Film merged = film_of({cut, passes.end()}, radii);
            merge_film(merged, film_of({passes.begin(), cut}, radii));
            CHECK(merged == straight);
        }
        CHECK(film_image(film_of(passes, radii)).pixels == film_image(straight).pixels);
    }
}

TEST_CASE("film: tiles put together in any order have the bits of the whole", "[film]")
{
    for (const bool radii : {false, true}) {
        const Film whole = film_of({0, 1, 2, 3, 9, 10}, radii);
        std::vector<Film> tiles;
        for (const PixelRect& pixels :
             {PixelRect{0, 0, 2, 3}, PixelRect{2, 0, 5, 1}, PixelRect{2, 1, 5, 3}}) {
            tiles.push_back(film_tile(film_of({0, 1, 2}, radii), pixels));
            tiles.push_back(film_tile(film_of({3, 9, 10}, radii), pixels));
        }
        std::mt19937 random(1);
        for (int round = 0; round < 5; ++round) {
            std::shuffle(tiles.begin(), tiles.end(), random);
            Film merged = make_film(kWidth, kHeight, 2.0, whole.bias);
            for (const Film& tile : tiles)
                merge_film(merged, tile);
            CHECK(merged == whole);
        }
        Film part = make_film(kWidth, kHeight, 2.0, whole.bias);
        merge_film(part, tiles[0]);
        REQUIRE(part.parts.size() == 1);
        const Image own = film_image(tiles[0]), image = film_image(part);
        for (int y = 0; y < kHeight; ++y)
            for (int x = 0; x < kWidth; ++x) {
                const int u = x - tiles[0].place.x, v = y - tiles[0].place.y;
                const bool inside = u >= 0 && v >= 0 && u < own.width && v < own.height;
                CHECK(image.at(x, y) == (inside ? own.at(u, v) : Rgb(0)));
            }
    }
}

TEST_CASE("film: a pixel is the mean of the passes that kept a sample of it", "[film]")
{
    std::vector<std::uint64_t> passes(20);
    std::iota(passes.begin(), passes.end(), 0);
    const Image image = film_image(film_of(passes, false));
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        glm::dvec3 sum(0.0);
        int kept = 0;
        for (const std::uint64_t pass : passes) {
            const PassImages images = wild_pass(pass, false);
            sum += (images.kept[i] != 0 ? 1.0 : 0.0) * glm::dvec3(images.radiance.pixels[i]);
            kept += images.kept[i];
        }
        for (int c = 0; c < 3; ++c)
            CHECK(image.pixels[i][c] == Approx(sum[c] / kept).epsilon(1e-6).margin(1e-6));
    }
    Film film = make_film(1, 1, 1.0, BiasKnowledge::unknown);
    PassImages none{Image(1, 1), {}, {}, {0}};
    none.radiance.pixels[0] = Rgb(std::numeric_limits<float>::quiet_NaN());
    add_pass(film, 0, none);
    CHECK(film_image(film).pixels[0] == Rgb(0));
}

TEST_CASE("film: values beyond the largest are counted and count as that, in any order", "[film]")
{
    const auto pass_of = [](float value) {
        PassImages pass{Image(1, 1), {}, {}, {1}};
        pass.radiance.pixels[0] = Rgb(value, -value, 1.0f);
        return pass;
    };
    Film up = make_film(1, 1, 1.0, BiasKnowledge::unbiased);
    Film down = up;
    const std::vector<float> values = {1e30f, 1.0f, 3e38f, -1e30f};
    for (std::size_t i = 0; i < values.size(); ++i) {
        add_pass(up, i, pass_of(values[i]));
        add_pass(down, values.size() - 1 - i, pass_of(values[values.size() - 1 - i]));
    }
    CHECK(up == down);
    CHECK(up.saturated == 6);
    const double most = std::ldexp(static_cast<double>(largest_value()), -up.scale);
    CHECK(film_image(up).pixels[0].x == Approx((most + 1) / 4));
    CHECK(film_image(up).pixels[0].z == 1.0f);
}

TEST_CASE("film: the unit goes with the mean, so that exposure does not change the image", "[film]")
{
    const PassImages pass = wild_pass(3, false);
    for (const int stops : {-40, -3, 17, 60}) {
        const float factor = std::ldexp(1.0f, stops);
        PassImages scaled = pass;
        for (Rgb& pixel : scaled.radiance.pixels)
            pixel *= factor;
        Film film = make_film(kWidth, kHeight, 2.0, BiasKnowledge::unknown);
        Film other = make_film(kWidth, kHeight, 2.0 * factor, BiasKnowledge::unknown);
        add_pass(film, 0, pass);
        add_pass(other, 0, scaled);
        CHECK(film.radiance == other.radiance);
    }
    for (const double mean : {0.0, -1.0, std::numeric_limits<double>::infinity(),
                              std::numeric_limits<double>::quiet_NaN()})
        CHECK(make_film(1, 1, mean, BiasKnowledge::unknown).scale ==
              make_film(1, 1, 1.0, BiasKnowledge::unknown).scale);
}

TEST_CASE("film: radii shrink from pass to pass by Knaus and Zwicker's rule", "[film]")
{
    const double alpha = GENERATE(2.0 / 3, 0.3);
    CHECK(radius_of_pass(0, alpha) == Approx(1.0));
    double square = 1;
    for (std::uint64_t pass = 1; pass < 200; ++pass) {
        const auto i = static_cast<double>(pass);
        square *= (i + alpha) / (i + 1);
        CHECK(radius_of_pass(pass, alpha) == Approx(std::sqrt(square)).epsilon(1e-9));
    }
}
