#include "common/math/frame.h"
#include "common/math/sampling.h"
#include "render/lights/spot_cone.h"
#include "tests/support/statistics.h"

#include <catch2/catch.hpp>

#include <vector>

using namespace hipmap;

namespace {

const glm::vec3 kAxis = glm::normalize(glm::vec3(1, 2, -2));

/// Narrow and wide cones with wide, narrow and no rims, of every kind.
std::vector<SpotCone> all_cones()
{
    std::vector<SpotCone> out;
    for (const SpotFalloff falloff :
         {SpotFalloff::gltf, SpotFalloff::smooth, SpotFalloff::smooth_cosine})
        for (const float cos_outer : {0.0f, 0.7f, 0.99f})
            for (const float blend : {1e-6f, 0.3f, 1.0f})
                out.push_back(
                    {kAxis,
                     std::max(cos_outer + (1 - cos_outer) * blend, std::nextafter(cos_outer, 1.0f)),
                     cos_outer, falloff});
    return out;
}

glm::vec3 direction_at(float cosine)
{
    return Frame(kAxis).to_world(direction_from_cosine(cosine, 0.1f));
}

/// The integral of the fall-off over the directions beyond a cosine, numerically.
double integral_below(const SpotCone& cone, double from)
{
    constexpr int kSteps = 100000;
    const double step = (1 - from) / kSteps;
    double sum = 0;
    for (int i = 0; i < kSteps; ++i)
        sum += falloff(cone, direction_at(static_cast<float>(1 - (i + 0.5) * step)));
    return sum * step * 2 * kPi;
}

} // namespace

TEST_CASE("spot cone: values worked out by hand", "[lights]")
{
    // In the middle of the rim from 0.6 to 1: t = 1/2, of which the square is 1/4 and the
    // smoothstep 1/2; the cosine there is 0.8.
    SpotCone cone{kAxis, 1, 0.6f, SpotFalloff::gltf};
    CHECK(falloff(cone, direction_at(0.8f)) == Approx(0.25).epsilon(1e-4));
    CHECK(falloff_integral(cone) == Approx(2 * kPi * 0.4 / 3));
    cone.falloff = SpotFalloff::smooth;
    CHECK(falloff(cone, direction_at(0.8f)) == Approx(0.5).epsilon(1e-4));
    CHECK(falloff_integral(cone) == Approx(2 * kPi * 0.2));
    cone.falloff = SpotFalloff::smooth_cosine;
    CHECK(falloff(cone, direction_at(0.8f)) == Approx(0.4).epsilon(1e-4));
    CHECK(falloff_integral(cone) == Approx(2 * kPi * 0.4 * (0.3 + 0.4 * 0.35)));
    // Within the inner cone.
    cone.cos_inner = 0.7f;
    CHECK(falloff(cone, direction_at(0.9f)) == Approx(0.9));
    cone.falloff = SpotFalloff::smooth;
    CHECK(falloff(cone, direction_at(0.9f)) == 1);
    for (const SpotCone& any : all_cones())
        CHECK(falloff(any, direction_at(any.cos_outer - 0.01f)) == 0);
}

TEST_CASE("spot cone: the integral is that of the fall-off", "[lights]")
{
    for (const SpotCone& cone : all_cones()) {
        INFO("kind " << static_cast<int>(cone.falloff) << ", outer " << cone.cos_outer << ", inner "
                     << cone.cos_inner);
        CHECK(falloff_integral(cone) == Approx(integral_below(cone, cone.cos_outer)).epsilon(2e-3));
    }
}

TEST_CASE("spot cone: directions are drawn in proportion to the fall-off", "[lights]")
{
    constexpr std::uint64_t kDraws = 50000;
    for (const SpotCone& cone : all_cones())
        for (const double part : {0.1, 0.5, 0.9}) {
            const double from = cone.cos_outer + part * (1 - double{cone.cos_outer});
            RunningMean within;
            for (std::uint64_t i = 0; i < kDraws; ++i) {
                RandomSequence random(3, RandomStream::photons, 0, i);
                const glm::vec3 drawn = sample_direction(cone, random);
                within.add(glm::dot(drawn, kAxis) > from ? 1.0 : 0.0);
            }
            INFO("kind " << static_cast<int>(cone.falloff) << ", outer " << cone.cos_outer
                         << ", inner " << cone.cos_inner << ", from " << from);
            const double truth = integral_below(cone, from) / falloff_integral(cone);
            CHECK(std::abs(within.mean() - truth) < kMostZ * within.standard_error() + 2e-3);
        }
}

TEST_CASE("spot cone: no draw leaves the cone", "[lights]")
{
    for (const SpotCone& cone : all_cones())
        for (std::uint64_t i = 0; i < 20000; ++i) {
            RandomSequence random(4, RandomStream::photons, 0, i);
            CHECK(glm::dot(sample_direction(cone, random), kAxis) > cone.cos_outer - 1e-5f);
        }
}
