#include "common/math/random.h"
#include "render/film/expected_light.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace hipmap;

namespace {

constexpr int kPixels = 20;
constexpr std::uint64_t kPasses = 100;

/// The light of some pixels, of mean one in each, which a pass finds so many times in each.
ExpectedLight light_in_pixels(double finds)
{
    ExpectedLight out;
    for (int pixel = 0; pixel < kPixels; ++pixel)
        add_light({.variance = 1 / finds / kPixels, .missing = 1.0 / kPixels, .finds = finds}, out);
    return out;
}

/// The relMSE of an image of it.
double square_of_image(double finds, std::uint64_t seed)
{
    double out = 0;
    for (std::uint64_t pixel = 0; pixel < kPixels; ++pixel) {
        RandomSequence random(seed, RandomStream::eye_paths, 0, pixel);
        int found = 0;
        for (std::uint64_t pass = 0; pass < kPasses; ++pass)
            found += random.next() < finds ? 1 : 0;
        const double mean = found / (finds * kPasses);
        out += (mean - 1) * (mean - 1) / kPixels;
    }
    return out;
}

} // namespace

TEST_CASE("expected light: the limit holds the error of 95 % of the images", "[film]")
{
    constexpr int kImages = 400;
    for (const double finds : {1e-5, 1e-4, 1e-3, 3e-3}) {
        const double most = 1.001 * missing_square(light_in_pixels(finds), kPasses);
        int inside = 0;
        for (std::uint64_t image = 0; image < kImages; ++image)
            inside += square_of_image(finds, image) <= most ? 1 : 0;
        INFO("found " << finds << " times in a pixel: " << inside << " of " << kImages);
        CHECK(inside >= 0.93 * kImages);
    }
}

TEST_CASE("expected light: passes that find it make the noise of images of it", "[film]")
{
    constexpr int kImages = 4000;
    const double finds = 1e-2;
    double sum = 0;
    for (std::uint64_t image = 0; image < kImages; ++image)
        sum += square_of_image(finds, image) / kImages;
    CHECK(unmet_square(light_in_pixels(finds), 1, kPasses) == Approx(sum).epsilon(0.05));
    CHECK(unmet_square(light_in_pixels(1e-9), 1, kPasses) < 1e-3); // they hardly ever do
    CHECK(unmet_square(ExpectedLight(), 1, 2) == 0);
}

TEST_CASE("expected light: what passes never find is missing, what they find is known", "[film]")
{
    CHECK(missing_square(ExpectedLight(), 1) == 0);
    CHECK(missing_square(light_in_pixels(1e-9), 1) == Approx(1).epsilon(0.01));
    const ExpectedLight expected = light_in_pixels(0.1);
    CHECK(missing_square(expected, 4) < 10);
    CHECK(missing_square(expected, 200) < 1e-6);
    CHECK(unmet_square(expected, 200, 400) < 1e-6);
    CHECK(light_in_pixels(8) == ExpectedLight());
    ExpectedLight none;
    add_light({.variance = INFINITY, .missing = 1, .finds = 1}, none);
    add_light({.variance = 0, .missing = 0, .finds = 0}, none);
    CHECK(none == ExpectedLight());
}
