#include "render/film/film_parts.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <random>

using namespace hipmap;

namespace {

constexpr int kSide = 7;

/// By brute force: the passes of each pixel.
using Held = std::vector<PassSet>;

Held held_by(const std::vector<FilmPart>& parts)
{
    Held out(kSide * kSide);
    for (const FilmPart& part : parts)
        for (int y = part.pixels.y0; y < part.pixels.y1; ++y)
            for (int x = part.pixels.x0; x < part.pixels.x1; ++x) {
                PassSet& passes = out[static_cast<std::size_t>(y * kSide + x)];
                REQUIRE(!common_pass(passes, part.passes));
                passes = united(passes, part.passes);
            }
    return out;
}

/// The tile of a grid that holds passes.
FilmPart tile_of(int number, int columns, int rows, PassSet passes)
{
    const int x = number % columns, y = number / columns;
    return {
        {x * kSide / columns, y * kSide / rows, (x + 1) * kSide / columns, (y + 1) * kSide / rows},
        std::move(passes)};
}

} // namespace

TEST_CASE("film parts: tiles that fill an image with the same passes are one part, in any order",
          "[film]")
{
    std::mt19937 random(1);
    const std::vector<std::pair<int, int>> grids = {{1, 1}, {2, 2}, {5, 3}, {7, 7}};
    for (const auto& [columns, rows] : grids) {
        std::vector<FilmPart> tiles;
        for (int i = 0; i < columns * rows; ++i)
            for (const PassSet& passes : {PassSet{{{0, 4}}}, PassSet{{{4, 9}}}})
                tiles.push_back(tile_of(i, columns, rows, passes));
        std::shuffle(tiles.begin(), tiles.end(), random);
        CHECK(joined_parts(tiles) == std::vector<FilmPart>{{{0, 0, kSide, kSide}, {{{0, 9}}}}});
    }
}

TEST_CASE("film parts: what each pixel holds stays, and alone decides the parts", "[film]")
{
    std::mt19937 random(2);
    for (int round = 0; round < 100; ++round) {
        std::vector<FilmPart> tiles;
        for (const std::uint64_t first : {0, 4, 8})
            for (int i = 0, rows = 1 + static_cast<int>(random() % 3); i < 2 * rows; ++i)
                if (random() % 3 > 0)
                    tiles.push_back(tile_of(i, 2, rows, {{{first, first + 4}}}));
        const std::vector<FilmPart> parts = joined_parts(tiles);
        CHECK(held_by(parts) == held_by(tiles));
        CHECK(are_valid(parts, kSide, kSide));
        std::vector<FilmPart> pixels; // the same, pixel by pixel
        const Held held = held_by(tiles);
        for (int i = 0; i < kSide * kSide; ++i)
            if (const PassSet& passes = held[static_cast<std::size_t>(i)]; !passes.ranges.empty())
                pixels.push_back(tile_of(i, kSide, kSide, passes));
        CHECK(joined_parts(pixels) == parts);

        const FilmPart wanted = {{1, 0, kSide, 5}, {{{2, 10}}}};
        const Held missing = held_by(missing_parts(parts, wanted));
        for (int i = 0; i < kSide * kSide; ++i) {
            const bool inside = i % kSide >= 1 && i / kSide < 5;
            const auto at = static_cast<std::size_t>(i);
            CHECK(missing[at] == (inside ? without(wanted.passes, held[at]) : PassSet()));
        }
    }
}

TEST_CASE("film parts: a pass is common where two lists hold it of a pixel", "[film]")
{
    const std::vector<FilmPart> a = {{{0, 0, 4, 4}, {{{0, 4}}}}};
    CHECK_FALSE(common_pass(a, {{{4, 0, 6, 4}, {{{0, 4}}}}}));
    CHECK_FALSE(common_pass(a, {{{3, 3, 6, 6}, {{{4, 8}}}}}));
    const auto common = common_pass(a, {{{3, 2, 6, 6}, {{{3, 8}}}}});
    REQUIRE(common);
    CHECK(common->pass == 3);
    CHECK(common->pixels == PixelRect{3, 2, 4, 4});
}
