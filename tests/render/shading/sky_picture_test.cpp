#include "common/math/random.h"
#include "common/math/sampling.h"
#include "render/shading/sky_picture.h"
#include "tests/support/statistics.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <map>

using namespace hipmap;

namespace {

/// Of pixels from 0 to some hundred, some rows and pixels black.
Image mottled(int width, int height)
{
    Image out(width, height);
    RandomSequence random(2, RandomStream::pictures, 0, 0);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const float level = std::exp(6 * random.next()) - 1;
            out.at(x, y) = y == 2 || (x + y) % 5 == 0 ? Rgb(0) : Rgb(0.5f, 1, 0.25f) * level;
        }
    return out;
}

/// Midpoints of a fine grid of pixels of the picture, with their solid angles.
template <typename Each>
void over_sky(int fine, Each&& each)
{
    for (int y = 0; y < fine; ++y)
        for (int x = 0; x < 2 * fine; ++x) {
            const double down = M_PI * (y + 0.5) / fine, turn = M_PI * (x + 0.5) / fine;
            const glm::vec3 direction(std::sin(down) * std::cos(turn), std::cos(down),
                                      std::sin(down) * std::sin(turn));
            const double solid_angle =
                M_PI / fine * (std::cos(M_PI * y / fine) - std::cos(M_PI * (y + 1) / fine));
            each(direction, solid_angle);
        }
}

} // namespace

TEST_CASE("sky picture: the density integrates to one and is in proportion to the light",
          "[shading]")
{
    const SkyPicture sky = make_sky_picture(mottled(16, 8), 2, 0.7f);
    double chance = 0, flux = 0;
    over_sky(16 * 24, [&](const glm::vec3& direction, double solid_angle) {
        const float density = sky_density(sky, direction);
        const float light = max_channel(sky_radiance(sky, direction));
        chance += density * solid_angle;
        flux += light * solid_angle;
        if (!(std::abs(density * sky.flux - light) <= 1e-4 * light))
            FAIL("density " << density << ", light " << light);
    });
    CHECK(chance == Approx(1).epsilon(0.01)); // the grid does not follow the turned pixels
    CHECK(flux == Approx(sky.flux).epsilon(0.01));
}

TEST_CASE("sky picture: each pixel is drawn as often as it shines", "[shading]")
{
    const int width = 12, height = 6;
    const SkyPicture sky = make_sky_picture(mottled(width, height), 1, -1.1f);
    RandomSequence random(8, RandomStream::pictures, 0, 0);
    std::map<float, double> drawn; // by radiance, which is another in each pixel
    constexpr int kDraws = 200'000;
    for (int i = 0; i < kDraws; ++i) {
        const glm::vec3 direction = sample_sky(sky, random.next2());
        CHECK(glm::length(direction) == Approx(1).epsilon(1e-5));
        drawn[max_channel(sky_radiance(sky, direction))] += 1;
    }
    double chi2 = 0, pixels = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const float level = max_channel(sky.radiance.at(x, y));
            const double solid_angle =
                2 * M_PI / width *
                (std::cos(M_PI * y / height) - std::cos(M_PI * (y + 1) / height));
            const double expected = kDraws * level * solid_angle / sky.flux;
            if (expected < 5)
                continue;
            chi2 += std::pow(drawn[level] - expected, 2) / expected;
            ++pixels;
        }
    CHECK(pixels > 30);
    CHECK(std::abs(chi2 - pixels) / std::sqrt(2 * pixels) < kMostZ);
}

TEST_CASE("sky picture: its middle is towards +x, its right towards +z, its top towards +y",
          "[shading]")
{
    Image picture(4, 3);
    picture.at(2, 1) = {1, 0, 0}; // just right of the middle
    picture.at(0, 0) = {0, 1, 0};
    const SkyPicture sky = make_sky_picture(picture, 3, 0);
    CHECK(sky_radiance(sky, glm::normalize(glm::vec3(1, 0, 0.5f))) == Rgb(3, 0, 0));
    CHECK(is_black(sky_radiance(sky, glm::normalize(glm::vec3(1, 0, -0.5f)))));
    CHECK(sky_radiance(sky, glm::normalize(glm::vec3(-0.1f, 1, -0.05f))) == Rgb(0, 3, 0));
    // Turned by a right angle, counter-clockwise from above: +x goes to -z.
    const SkyPicture turned = make_sky_picture(picture, 3, 0.5f * kPi);
    CHECK(sky_radiance(turned, glm::normalize(glm::vec3(0.5f, 0, -1))) == Rgb(3, 0, 0));
}

TEST_CASE("sky picture: a black one is none", "[shading]")
{
    CHECK(make_sky_picture(Image(8, 4), 1, 0).empty());
    CHECK(make_sky_picture(mottled(8, 4), 0, 0).empty());
    CHECK(make_sky_picture(Image(), 1, 0).empty());
}
