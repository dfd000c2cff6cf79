#include "common/math/random.h"
#include "common/math/sampling.h"
#include "render/lights/environment_map.h"
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

Rgb radiance_from(const EnvironmentMap& map, const glm::vec3& direction)
{
    return at_direction(map, direction).radiance;
}

/// Midpoints of a fine grid of pixels of the texture, with their solid angles.
template <typename Each>
void over_directions(int fine, Each&& each)
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

TEST_CASE("environment map: the pdf integrates to one and is in proportion to the light",
          "[lights]")
{
    const EnvironmentMap map = make_environment_map(mottled(16, 8), 2, 0.7f);
    double probability = 0, flux = 0;
    over_directions(16 * 24, [&](const glm::vec3& direction, double solid_angle) {
        const float pdf = at_direction(map, direction).pdf;
        const float light = max_channel(radiance_from(map, direction));
        probability += pdf * solid_angle;
        flux += light * solid_angle;
        if (!(std::abs(pdf * map.brightest_flux - light) <= 1e-4 * light))
            FAIL("pdf " << pdf << ", light " << light);
    });
    CHECK(probability == Approx(1).epsilon(0.01)); // the grid does not follow the turned pixels
    CHECK(flux == Approx(map.brightest_flux).epsilon(0.01));
}

TEST_CASE("environment map: each pixel is drawn as often as it emits", "[lights]")
{
    const int width = 12, height = 6;
    const EnvironmentMap map = make_environment_map(mottled(width, height), 1, -1.1f);
    RandomSequence random(8, RandomStream::pictures, 0, 0);
    std::map<float, double> drawn; // by radiance, which is another in each pixel
    constexpr int kDraws = 200'000;
    for (int i = 0; i < kDraws; ++i) {
        const glm::vec3 direction = sample_direction(map, random.next2());
        CHECK(glm::length(direction) == Approx(1).epsilon(1e-5));
        drawn[max_channel(radiance_from(map, direction))] += 1;
    }
    double chi2 = 0, pixels = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const float level = max_channel(map.radiance.at(x, y));
            const double solid_angle =
                2 * M_PI / width *
                (std::cos(M_PI * y / height) - std::cos(M_PI * (y + 1) / height));
            const double expected = kDraws * level * solid_angle / map.brightest_flux;
            if (expected < 5)
                continue;
            chi2 += std::pow(drawn[level] - expected, 2) / expected;
            ++pixels;
        }
    CHECK(pixels > 30);
    CHECK(std::abs(chi2 - pixels) / std::sqrt(2 * pixels) < kMostZ);
}

TEST_CASE("environment map: its middle is towards +x, its right towards +z, its top towards +y",
          "[lights]")
{
    Image picture(4, 3);
    picture.at(2, 1) = {1, 0, 0}; // just right of the middle
    picture.at(0, 0) = {0, 1, 0};
    const EnvironmentMap map = make_environment_map(picture, 3, 0);
    CHECK(radiance_from(map, glm::normalize(glm::vec3(1, 0, 0.5f))) == Rgb(3, 0, 0));
    CHECK(is_black(radiance_from(map, glm::normalize(glm::vec3(1, 0, -0.5f)))));
    CHECK(radiance_from(map, glm::normalize(glm::vec3(-0.1f, 1, -0.05f))) == Rgb(0, 3, 0));
    // Turned by a right angle, counter-clockwise from above: +x goes to -z.
    const EnvironmentMap turned = make_environment_map(picture, 3, 0.5f * kPi);
    CHECK(radiance_from(turned, glm::normalize(glm::vec3(0.5f, 0, -1))) == Rgb(3, 0, 0));
}

TEST_CASE("environment map: a black one is none", "[lights]")
{
    CHECK(make_environment_map(Image(8, 4), 1, 0).empty());
    CHECK(make_environment_map(mottled(8, 4), 0, 0).empty());
    CHECK(make_environment_map(Image(), 1, 0).empty());
}

TEST_CASE("environment map: the numbers that draw a direction are found again", "[lights]")
{
    const EnvironmentMap map = make_environment_map(mottled(16, 8), 1, 0.7f);
    RandomSequence random(3, RandomStream::pictures, 0, 0);
    for (int i = 0; i < 200; ++i) {
        const glm::vec2 u = random.next2();
        const glm::vec2 found = direction_sample_of(map, sample_direction(map, u));
        CHECK(found.x == Approx(u.x).margin(1e-3));
        CHECK(found.y == Approx(u.y).margin(1e-3));
    }
}
