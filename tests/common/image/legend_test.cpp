#include "common/image/colour_scale.h"
#include "common/image/legend.h"

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include <algorithm>

using namespace hipmap;

TEST_CASE("scale_colour: lightness rises all the way", "[image]")
{
    for (int i = 0; i < 100; ++i)
        REQUIRE(luminance(scale_colour((i + 1) / 100.0)) > luminance(scale_colour(i / 100.0)));
}

TEST_CASE("add_legend: rows are added until every entry has its place", "[image]")
{
    const Image picture(100, 10);
    const LegendEntry entry{{Rgb(1, 0, 0)}, "connected"};
    const Image one = add_legend(picture, {entry});
    const Image three = add_legend(picture, {entry, entry, entry});
    CHECK(one.width == 100);
    CHECK(three.height > one.height);
    const auto red = [](const Image& image) {
        return std::ranges::count_if(
            image.pixels, [](const Rgb& c) { return glm::length(c - Rgb(1, 0, 0)) < 1e-3f; });
    };
    CHECK(red(one) > 50);
    CHECK(red(three) == 3 * red(one));
    CHECK(add_legend(Image(1, 1), {entry}).width == 1); // too narrow for any of it
}

TEST_CASE("add_legend: a text that is too long for a row is broken, and none of it is lost",
          "[image]")
{
    const LegendEntry scale{{Rgb(1, 0, 0), Rgb(0, 1, 0)}, "error: 0.1 to 100 %, logarithmic"};
    const auto ink = [&](int width) {
        const Image image = add_legend(Image(width, 1), {scale});
        return std::ranges::count_if(image.pixels.begin() + width, image.pixels.end(),
                                     [](const Rgb& c) { return c == Rgb(0.1f); });
    };
    const auto height = [&](int width) { return add_legend(Image(width, 1), {scale}).height; };
    CHECK(ink(1000) > 100);
    CHECK(ink(256) == ink(1000));
    CHECK(ink(192) == ink(1000));
    CHECK(height(1000) < height(256));
    CHECK(height(256) < height(192));
    CHECK(add_legend(Image(256, 1), {scale, scale}).height > height(256) + 20);
    CHECK(add_legend(Image(9, 1), {{{Rgb(1)}, ""}, scale}).height > 1);
}

TEST_CASE("hex_colour: what an 8-bit picture would show", "[image]")
{
    CHECK(hex_colour(Rgb(0, 1, 2)) == "#00ffff");
    CHECK(hex_colour(Rgb(0.216f, -1, std::nanf(""))) == "#800000"); // the middle of sRGB
}
