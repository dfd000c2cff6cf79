#include "common/math/sampling.h"
#include "render/lights/beam_light.h"
#include "render/lights/light.h"
#include "tests/support/statistics.h"

#include <catch2/catch.hpp>

#include <tuple>

using namespace hipmap;

namespace {

/// A sheared light one above the floor, which looks down; half its sides are 0.2 and 0.1 long.
BeamLight beam(bool is_disc)
{
    SceneBeamLight light;
    light.is_disc = is_disc;
    light.centre = {3, 1, -2};
    light.right = {3.2, 1, -2};
    light.up = {3.05, 1, -1.9};
    light.direction = {0, -1, 0};
    light.irradiance = glm::dvec3(1, 2, 3);
    return light_from(light, {});
}

/// Irradiance of a point that faces up, at units of the light's sides.
float irradiance(const BeamLight& light, float right, float up, float below)
{
    RandomSequence random(1, RandomStream::photons, 0, 0);
    const glm::vec3 point = light.shape.centre + right * light.shape.half_right +
                            up * light.shape.half_up - glm::vec3(0, below, 0);
    const auto sample = sample_li(light, {point, {0, 1, 0}}, random);
    if (!sample)
        return 0;
    CHECK(sample->pdf == 0);
    CHECK(sample->direction == glm::vec3(0, 1, 0));
    CHECK(glm::length(sample->point - (point + glm::vec3(0, below, 0))) < 1e-6f);
    return sample->light.y;
}

} // namespace

TEST_CASE("beam light: it lights its own shape, as brightly at any distance", "[lights]")
{
    for (const float below : {1e-3f, 1.0f, 1000.0f})
        for (const bool is_disc : {false, true}) {
            const BeamLight light = beam(is_disc);
            CHECK(irradiance(light, 0, 0, below) == 2);
            CHECK(irradiance(light, 0.99f, 0, below) == 2);
            CHECK(irradiance(light, 0.9f, -0.9f, below) == (is_disc ? 0 : 2));
            CHECK(irradiance(light, 1.01f, 0, below) == 0);
            CHECK(irradiance(light, 0, -1.01f, below) == 0);
            CHECK(irradiance(light, 0, 0, -below) == 0);
        }
    CHECK(power(beam(false)).z == Approx(3 * 0.4 * 0.2));
    CHECK(power(beam(true)).z == Approx(3 * kPi * 0.2 * 0.1));
}

TEST_CASE("beam light: without area it is dark", "[lights]")
{
    BeamLight light = beam(false);
    light.shape.half_up = light.shape.half_right;
    CHECK(irradiance(light, 0, 0, 1) == 0);
    CHECK(path_power(light) == 0);
}

TEST_CASE("beam light: aimed paths lose no power, however much wider the targets are", "[lights]")
{
    // Targets: narrower than the beam, partly beside it, and far wider.
    const auto [offset, radius, is_disc] = GENERATE(table<float, float, bool>(
        {{0.0f, 0.05f, false}, {0.15f, 0.1f, false}, {0.15f, 0.1f, true}, {0.0f, 50.0f, true}}));
    const BeamLight light = beam(is_disc);
    const TargetSphere target{{3 + offset, -2, -2}, radius};
    RunningMean plain, aimed;
    for (std::uint64_t i = 0; i < 20'000; ++i) {
        RandomSequence random(5, RandomStream::photons, 0, i);
        for (const bool aims : {false, true}) {
            const EmittedPath path = aims ? sample_aimed_emission(light, {}, {target}, random)
                                          : sample_emission(light, {}, random);
            CHECK(path.ray.direction == light.direction);
            const glm::vec3 way = target.centre - path.ray.origin;
            const bool hits = glm::length(glm::cross(way, path.ray.direction)) < radius;
            (aims ? aimed : plain).add(hits ? path.power.y : 0);
        }
    }
    INFO("plain " << plain.mean() << " +- " << plain.standard_error() << ", aimed " << aimed.mean()
                  << " +- " << aimed.standard_error());
    CHECK(aimed.mean() > 0);
    CHECK(std::abs(plain.mean() - aimed.mean()) <=
          kMostZ * std::hypot(plain.standard_error(), aimed.standard_error()) + 1e-6);
    CHECK(aimed.standard_error() <= 1.01 * plain.standard_error());
}

TEST_CASE("beam light: bounds hold all that it lights, and not what is beside it", "[lights]")
{
    const LightBounds around = *bounds(beam(false));
    for (const float below : {1e-3f, 0.1f, 1.0f, 1000.0f})
        for (const float right : {-1.0f, 0.0f, 1.0f})
            for (const float up : {-1.0f, 0.3f, 1.0f}) {
                const BeamLight light = beam(false);
                const glm::vec3 point = light.shape.centre + right * light.shape.half_right +
                                        up * light.shape.half_up - glm::vec3(0, below, 0);
                CHECK(importance(around, {point, {0, 1, 0}}) > 0);
            }
    CHECK(importance(around, {{3.5f, -10, -2}, {0, 1, 0}}) == 0);
    CHECK(importance(around, {{3, 2, -2}, {0, -1, 0}}) == 0);
}
