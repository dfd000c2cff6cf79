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

TEST_CASE("hex_colour: what an 8-bit picture would show", "[image]")
{
    CHECK(hex_colour(Rgb(0, 1, 2)) == "#00ffff");
    CHECK(hex_colour(Rgb(0.216f, -1, std::nanf(""))) == "#800000"); // the middle of sRGB
}
