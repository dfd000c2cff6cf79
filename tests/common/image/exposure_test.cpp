#include "common/image/exposure.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

namespace hipmap {

TEST_CASE("auto_exposure: the 90th percentile comes to 0.5", "[image]")
{
    Image image(10, 10);
    for (int i = 0; i < 100; ++i)
        image.pixels[static_cast<std::size_t>(i * 37 % 100)] = Rgb(static_cast<float>(i + 1));
    CHECK(90 * std::exp2(auto_exposure(image)) == Approx(0.5).epsilon(1e-5));
}

TEST_CASE("auto_exposure: black, negative and non-finite pixels do not count", "[image]")
{
    Image image(4, 2);
    image.pixels[1] = Rgb(0.125f);
    image.pixels[3] = Rgb(std::numeric_limits<float>::quiet_NaN());
    image.pixels[5] = Rgb(std::numeric_limits<float>::infinity());
    image.pixels[6] = Rgb(-1.0f);
    CHECK(auto_exposure(image) == Approx(2.0).epsilon(1e-6));
}

TEST_CASE("auto_exposure: twice the light is one stop less", "[image]")
{
    Image image(3, 1);
    image.pixels = {{0.1f, 0.2f, 0.3f}, {1.0f, 0.5f, 0.0f}, {0.3f, 0.3f, 0.9f}};
    Image brighter = image;
    for (Rgb& pixel : brighter.pixels)
        pixel *= 2.0f;
    CHECK(auto_exposure(brighter) == Approx(auto_exposure(image) - 1));
}

TEST_CASE("auto_exposure: is finite for any image", "[image]")
{
    CHECK(auto_exposure(Image(3, 3)) == 0.0f);
    CHECK(auto_exposure(Image()) == 0.0f);
    Image image(1, 1);
    image.pixels[0] = Rgb(std::numeric_limits<float>::denorm_min() * 4);
    CHECK(std::isfinite(auto_exposure(image)));
    image.pixels[0] = Rgb(3e38f);
    CHECK(std::isfinite(auto_exposure(image)));
}

} // namespace hipmap
