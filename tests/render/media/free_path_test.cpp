#include "render/media/free_path.h"
#include "tests/support/statistics.h"

#include <catch2/catch.hpp>
#include <rapidcheck/catch.h>

#include <array>
#include <limits>

using namespace hipmap;

namespace {

Medium coloured()
{
    Medium out;
    out.absorption = {0.5f, 0, 3};
    out.scattering = {1, 2, 0.25f};
    return out;
}

} // namespace

TEST_CASE(
    "sample_free_path: what it passes on and what it scatters are as they should be, by channel",
    "[media]")
{
    constexpr float kLimit = 0.7f;
    const Medium medium = coloured();
    for (const Rgb& carried : {Rgb(1), Rgb(0.01f, 1, 5), Rgb(0, 0, 2), Rgb(1, 0, 0)}) {
        std::array<RunningMean, 3> passed, scattered, where;
        for (std::uint64_t i = 0; i < 20000; ++i) {
            RandomSequence random(1, RandomStream::pictures, 0, i);
            const FreePath free_path = sample_free_path(medium, kLimit, carried, random);
            for (int c = 0; c < 3; ++c) {
                const double weight = double{carried[c]} * free_path.weight[c];
                passed[c].add(free_path.scattered ? 0 : weight);
                scattered[c].add(free_path.scattered ? weight : 0);
                where[c].add(free_path.scattered ? weight * free_path.optical_depth : 0);
            }
        }
        for (int c = 0; c < 3; ++c) {
            if (carried[c] == 0)
                continue; // no draw is made for it: what it is given is multiplied with nothing
            const double s = medium.scattering[c], t = s + medium.absorption[c];
            const double left = std::exp(-t * kLimit);
            INFO("channel " << c << ", carried " << carried[c]);
            CHECK(std::abs(passed[c].z_score(carried[c] * left)) < kMostZ);
            CHECK(std::abs(scattered[c].z_score(carried[c] * s / t * (1 - left))) < kMostZ);
            CHECK(std::abs(where[c].z_score(carried[c] * s / t *
                                            ((1 - left) / t - kLimit * left))) < kMostZ);
        }
    }
}

TEST_CASE("sample_free_path: what is carried never grows and is finite", "[media]")
{
    rc::prop("sum over the channels", [] {
        const auto coefficient = rc::gen::map(rc::gen::inRange(0, 40), [](int i) {
            return i == 0 ? 0.0f : std::exp(static_cast<float>(i - 20));
        });
        Medium medium;
        Rgb carried;
        for (int c = 0; c < 3; ++c) {
            medium.absorption[c] = *coefficient;
            medium.scattering[c] = *coefficient;
            carried[c] = *coefficient;
        }
        const float limit =
            *rc::gen::element(1e-6f, 1.0f, 1e6f, std::numeric_limits<float>::infinity());
        RandomSequence random(*rc::gen::arbitrary<std::uint64_t>(), RandomStream::pictures, 0, 0);
        const FreePath free_path = sample_free_path(medium, limit, carried, random);
        const Rgb after = carried * free_path.weight;
        RC_ASSERT(is_finite(after));
        RC_ASSERT(after.x + after.y + after.z <=
                  (carried.x + carried.y + carried.z) * (1 + 0x1p-18f));
    });
}

TEST_CASE("a medium without scattering lets all light come to the end, less what it absorbs",
          "[media]")
{
    Medium medium = coloured();
    medium.scattering = Rgb(0);
    RandomSequence random(1, RandomStream::pictures, 0, 0);
    const FreePath free_path = sample_free_path(medium, 2, Rgb(1), random);
    CHECK(!free_path.scattered);
    CHECK(free_path.weight.x == Approx(std::exp(-1.0)));
    CHECK(free_path.weight.y == 1);
    CHECK(transmitted(medium.absorption, std::numeric_limits<float>::infinity()) == Rgb(0, 1, 0));
}

TEST_CASE("emitted_along: e/a (1 - exp(-a d)), and e d without absorption", "[media]")
{
    Medium medium;
    medium.absorption = {2, 0, 1e-6f};
    medium.emission = Rgb(3);
    const Rgb found = emitted_along(medium, 0.5f);
    CHECK(found.x == Approx(1.5 * (1 - std::exp(-1.0))));
    CHECK(found.y == 1.5f);
    CHECK(found.z == Approx(1.5));
}
