#include "common/math/sampling.h"
#include "render/lights/ies_light.h"
#include "tests/support/statistics.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using namespace hipmap;

namespace {

using std::numbers::pi;

/// A light at the origin that looks down, with azimuth 0 towards +x.
IesLight with_web(const PhotometricWeb& web)
{
    SceneIesLight light;
    light.direction = {0, -1, 0};
    light.start = {1, 0, 0};
    light.intensity = glm::dvec3(1, 2, 3);
    light.web = web;
    return light_from(light, {});
}

glm::vec3 direction_of(double polar, double azimuth)
{
    // Across the axis and azimuth 0: cross(-y, x) = z.
    return {std::sin(polar) * std::cos(azimuth), -std::cos(polar),
            std::sin(polar) * std::sin(azimuth)};
}

/// Webs that emit all around, to one side, into a narrow beam, into a hollow one, and by a coarse
/// table.
std::vector<PhotometricWeb> all_webs()
{
    return {
        {{0, pi}, {0, 2 * pi}, {5, 5, 5, 5}},
        {{0, pi / 2}, {0, 2 * pi}, {2, 2, 6, 6}},
        {{pi / 2, 3, pi}, {0, 2 * pi}, {0, 0, 4, 4, 1, 1}},
        {{0, 1e-3, 2e-3, pi / 2}, {0, 2 * pi}, {1e6, 1e6, 1e6, 1e6, 0, 0, 0, 0}},
        {{0, 0.5, 1.0, 1.5}, {0, 1, 4, 2 * pi}, {0, 0, 0, 0, 3, 0, 0, 3, 1, 7, 0, 1, 0, 0, 9, 0}}};
}

/// The integral of intensity times a function of direction over the web's directions, by midpoints.
template <typename Of>
double integral(const IesLight& light, const Of& of)
{
    constexpr int kRows = 400, kColumns = 200;
    double sum = 0;
    for (std::size_t band = 0; band + 1 < light.web.polar.size(); ++band) {
        const double low = light.web.polar[band], width = light.web.polar[band + 1] - low;
        for (int i = 0; i < kRows; ++i)
            for (int j = 0; j < kColumns; ++j) {
                const double polar = low + width * (i + 0.5) / kRows;
                const glm::vec3 direction = direction_of(polar, 2 * pi * (j + 0.5) / kColumns);
                sum += candela_along(light, direction) * of(direction) * std::sin(polar) * width;
            }
    }
    return sum / kRows * 2 * pi / kColumns;
}

} // namespace

TEST_CASE("ies light: intensities are those of the table, and linear in both angles between",
          "[lights]")
{
    const IesLight light = with_web({{0, 1, 1.5}, {0, pi, 2 * pi}, {4, 4, 4, 0, 8, 0, 2, 6, 2}});
    CHECK(candela_along(light, {0, -1, 0}) == Approx(4));
    CHECK(candela_along(light, direction_of(1, 0)) == Approx(0).margin(1e-5));
    CHECK(candela_along(light, direction_of(1, pi)) == Approx(8));
    CHECK(candela_along(light, direction_of(1, pi / 4)) == Approx(2));
    CHECK(candela_along(light, direction_of(1, -pi / 4)) == Approx(2));
    CHECK(candela_along(light, direction_of(0.5, pi)) == Approx(6));
    CHECK(candela_along(light, direction_of(1.25, pi / 2)) == Approx(4));
    CHECK(candela_along(light, direction_of(1.501, 0)) == 0);
    CHECK(candela_along(light, {0, 1, 0}) == 0);
}

TEST_CASE("ies light: irradiance is intensity over squared distance", "[lights]")
{
    const IesLight light = with_web({{0, 1, 1.5}, {0, 2 * pi}, {4, 4, 8, 8, 2, 2}});
    RandomSequence random(1, RandomStream::photons, 0, 0);
    const auto sample = sample_li(light, {2.0f * direction_of(0.5, 1), {0, 1, 0}}, random);
    REQUIRE(sample);
    CHECK(sample->light.y == Approx(2 * 6.0 / 4));
    CHECK(sample->pdf == 0);
    CHECK_FALSE(sample_li(light, {{0, 0, 0}, {0, 1, 0}}, random));
}

TEST_CASE("ies light: power in closed form", "[lights]")
{
    // The same intensity everywhere: 4 pi I.
    CHECK(power(with_web({{0, pi}, {0, 2 * pi}, {5, 5, 5, 5}})).x == Approx(4 * pi * 5));
    // From a to b over a half sphere, linear in the angle: the integral of the angle times its sine
    // is 1, so 2 pi (a + (b - a) 2/pi).
    CHECK(power(with_web({{0, pi / 2}, {0, 2 * pi}, {2, 2, 6, 6}})).y ==
          Approx(2 * 2 * pi * (2 + 4 * 2 / pi)));
    // From 0 to 8 and back around the axis: 4 on average.
    CHECK(power(with_web({{0, pi}, {0, pi, 2 * pi}, {0, 8, 0, 0, 8, 0}})).z ==
          Approx(3 * 4 * pi * 4));
    // A beam of 1 mrad in the limit of flat space: 1e6 over its disc, and a rim that falls to 0.
    const double beam = pi * 1 + 2 * pi * (1.5 - 5.0 / 6);
    CHECK(power(with_web(all_webs()[3])).x == Approx(beam).epsilon(1e-5));
    for (const PhotometricWeb& web : all_webs()) {
        const IesLight light = with_web(web);
        CHECK(power(light).x ==
              Approx(integral(light, [](const glm::vec3&) { return 1; })).epsilon(1e-3));
    }
}

TEST_CASE("ies light: directions are drawn in proportion to the intensity", "[lights]")
{
    constexpr std::uint64_t kDraws = 20'000;
    for (const PhotometricWeb& web : all_webs()) {
        const IesLight light = with_web(web);
        const auto in_plane = [](const glm::vec3& d) { return double{d.x} * d.z + 2 * d.x; };
        const auto along = [](const glm::vec3& d) { return std::abs(double{d.y}); };
        const auto in_part = [](const glm::vec3& d) { return d.z > 0 && d.x < 0.4f ? 1.0 : 0.0; };
        RunningMean means[3];
        for (std::uint64_t i = 0; i < kDraws; ++i) {
            RandomSequence random(3, RandomStream::photons, 0, i);
            const glm::vec3 drawn = sample_direction(light, random);
            REQUIRE(glm::length(drawn) == Approx(1).epsilon(1e-5));
            REQUIRE(std::acos(std::min(1.0f, -drawn.y)) <= web.polar.back() + 1e-3);
            means[0].add(in_plane(drawn));
            means[1].add(along(drawn));
            means[2].add(in_part(drawn));
        }
        const double whole = power(light).x;
        const double truths[] = {integral(light, in_plane) / whole, integral(light, along) / whole,
                                 integral(light, in_part) / whole};
        for (int i = 0; i < 3; ++i) {
            INFO("of " << web.polar.size() << " polar angles, function " << i << ": "
                       << means[i].mean() << " and " << truths[i]);
            CHECK(std::abs(means[i].mean() - truths[i]) <
                  kMostZ * means[i].standard_error() + 2e-3);
        }
    }
}

TEST_CASE("ies light: bounds hold all directions that have light", "[lights]")
{
    for (const PhotometricWeb& web : all_webs()) {
        const IesLight light = with_web(web);
        const LightBounds around = *bounds(light);
        for (std::uint64_t i = 0; i < 2000; ++i) {
            RandomSequence random(5, RandomStream::photons, 0, i);
            const glm::vec3 drawn = sample_direction(light, random);
            CHECK(importance(around, {0.5f * drawn, glm::vec3(0)}) > 0);
        }
    }
    const LightBounds beam = *bounds(with_web(all_webs()[3]));
    CHECK(importance(beam, {0.5f * direction_of(0.1, 1), glm::vec3(0)}) == 0);
}
