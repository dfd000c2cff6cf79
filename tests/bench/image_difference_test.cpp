#include "bench/image_difference.h"

#include <catch2/catch.hpp>

#include <cmath>

namespace hipmap {

namespace {

Image reference_image()
{
    Image image(2, 2);
    image.pixels = {{1, 2, 3}, {0, 0.5f, 1}, {4, 4, 4}, {0.25f, 0, 0.25f}};
    return image;
}

Image scaled(Image image, float factor)
{
    for (Rgb& pixel : image.pixels)
        pixel *= factor;
    return image;
}

} // namespace

TEST_CASE("mean_radiance: is the mean of each channel", "[bench]")
{
    const glm::dvec3 mean = mean_radiance(reference_image());
    CHECK(mean.x == Approx(5.25 / 4));
    CHECK(mean.y == Approx(6.5 / 4));
    CHECK(mean.z == Approx(8.25 / 4));
}

TEST_CASE("relative_mse: a uniform image that is off by a tenth", "[bench]")
{
    Image reference(3, 5);
    for (Rgb& pixel : reference.pixels)
        pixel = Rgb(2.0f);
    // (0.2)^2 / (2^2 + (0.1 * 2)^2)
    CHECK(relative_mse(scaled(reference, 1.1f), reference) == Approx(0.04 / 4.04).epsilon(1e-5));
    CHECK(relative_mse(scaled(reference, 0.9f), reference) == Approx(0.04 / 4.04).epsilon(1e-5));
}

TEST_CASE("relative_mse: exposure does not matter", "[bench]")
{
    const Image reference = reference_image();
    Image image = reference;
    image.pixels[2].y += 0.5f;
    image.pixels[3].y += 0.125f;
    const double error = relative_mse(image, reference);
    CHECK(error > 0);
    CHECK(relative_mse(scaled(image, 64), scaled(reference, 64)) == Approx(error));
}

TEST_CASE("relative_mse: the same image is free of error, black or not", "[bench]")
{
    CHECK(relative_mse(reference_image(), reference_image()) == 0);
    CHECK(relative_mse(Image(2, 2), Image(2, 2)) == 0);
    CHECK(std::isinf(relative_mse(reference_image(), Image(2, 2))));
}

TEST_CASE("side_by_side: each half is one of the pictures", "[bench]")
{
    const Image left = reference_image();
    Image right(1, 2);
    right.pixels = {Rgb(7.0f), Rgb(8.0f)};
    const Image both = side_by_side(left, right);
    REQUIRE(both.width == 3);
    for (int y = 0; y < 2; ++y) {
        CHECK(both.at(0, y) == left.at(0, y));
        CHECK(both.at(1, y) == left.at(1, y));
        CHECK(both.at(2, y) == right.at(0, y));
    }
}

} // namespace hipmap
