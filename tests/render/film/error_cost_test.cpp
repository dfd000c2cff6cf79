#include "render/film/error_cost.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace hipmap;

namespace {

constexpr double kAlpha = 2.0 / 3;

/// Checks of a film whose error follows a law exactly, at 0.5 s a pass.
std::vector<ErrorCheck> checks_of(const ErrorLaw& law, std::uint64_t last)
{
    std::vector<ErrorCheck> checks;
    for (std::uint64_t passes = next_check(0); passes <= last; passes = next_check(passes)) {
        const auto n = static_cast<double>(passes);
        ImageError error;
        error.photon2 = law.by_photon / std::pow(n, law.photon_power);
        error.noise2 = law.by_pass / n + error.photon2;
        error.bias2 = law.by_bias / std::pow(n, law.bias_power);
        error.order = law.bias_power / (1 - law.photon_power);
        error.error = error_after(law, n);
        checks.push_back({passes, 0.5 * n, error});
    }
    return checks;
}

} // namespace

TEST_CASE("error cost: checks are spaced geometrically and never repeat", "[film]")
{
    std::vector<std::uint64_t> found;
    for (std::uint64_t passes = 0; passes < 200; passes = next_check(passes))
        found.push_back(passes);
    CHECK(found == std::vector<std::uint64_t>{0, 4, 6, 8, 11, 16, 23, 32, 45, 64, 91, 128, 181});
    CHECK(next_check(12) == 16);
    std::vector<std::uint64_t> looks;
    for (std::uint64_t passes = 0; passes < 23; passes = next_look(passes))
        looks.push_back(passes);
    CHECK(looks == std::vector<std::uint64_t>{0, 2, 3, 4, 6, 8, 11, 16});
    CHECK(next_check(16) == 23);
}

TEST_CASE("error cost: a law of all parts is found again, and halving costs what it says", "[film]")
{
    for (const double alpha : {kAlpha, 0.5})
        for (ErrorLaw law : {ErrorLaw{0.3, 0.2}, {0, 0.1}, {0.5, 0}, {0.3, 0.2, 0, 0.1}}) {
            law.photon_power = alpha;
            law.bias_power = 2 * (1 - alpha);
            const auto checks = checks_of(law, 128);
            const ErrorLaw found = error_law(checks, alpha);
            const double hidden = 128 * law.by_bias / std::pow(128, law.bias_power) * 16 / 144;
            CHECK(found.by_pass == Approx(law.by_pass + hidden).margin(1e-9));
            CHECK(found.by_photon == Approx(law.by_photon).margin(1e-9));
            CHECK(found.by_bias == Approx(law.by_bias * 128 / 144).margin(1e-9));
            CHECK(error_after(found, 128) == Approx(error_after(law, 128)));
            const double half = checks.back().error.error / 2;
            const ErrorCost cost = error_cost(checks, found, half, {1000, 7});
            CHECK(error_after(law, cost.passes) <= half * (1 + 1e-6));
            std::uint64_t before = 0;
            while (static_cast<double>(next_check(before)) < cost.passes)
                before = next_check(before);
            CHECK(static_cast<double>(next_check(before)) == cost.passes);
            CHECK(error_after(law, static_cast<double>(before)) > half);
            CHECK(cost.seconds == Approx(7 + 0.5 * cost.passes));
            CHECK(cost.photons == 1000 * cost.passes);
        }
}

TEST_CASE("error cost: to halve an error costs 4 times the passes, and 8 by photons or bias",
          "[film]")
{
    const auto factor = [](const ErrorLaw& law) {
        const auto checks = checks_of(law, 128);
        return error_cost(checks, error_law(checks, kAlpha), checks.back().error.error / 2, {})
                   .passes /
               128;
    };
    CHECK(factor({0.3, 0}) == Approx(4).epsilon(0.01));
    CHECK(factor({0, 0.3}) == Approx(8).epsilon(0.01));
    CHECK(factor({0, 0, kAlpha, 0.3, 2.0 / 3}) == Approx(8).epsilon(0.01));
    // An order that is measured does not count.
    CHECK(factor({0, 0, kAlpha, 0.3, 1.0 / 3}) == Approx(8).epsilon(0.01));
}

TEST_CASE("error cost: light that few samples find makes it a range, until the error is met",
          "[film]")
{
    constexpr double kError = 0.01;
    const auto checks = checks_of({0.001}, 4);
    const auto cost = [&](double finds, std::span<const ErrorCheck> of) {
        ExpectedLight rare;
        for (int pixel = 0; pixel < 1000; ++pixel)
            add_light({.variance = 4e-6, .missing = 1e-9, .finds = finds / 1000}, rare);
        return error_cost(of, error_law(of, kAlpha, rare), kError, {1, 7});
    };
    const ErrorCost known = cost(10'000, checks);
    CHECK(known.most_passes == known.passes);
    CHECK(known.most_seconds == known.seconds);
    const ErrorCost range = cost(1, checks);
    CHECK(range.passes == known.passes);
    CHECK(range.most_passes == passes_for({0.005}, kError));
    CHECK(range.most_seconds == Approx(7 + 0.5 * range.most_passes));
    CHECK(cost(1e-6, checks).most_passes == known.passes); // nobody finds it
    CHECK(cost(1, checks_of({0.001}, 16)).most_passes == known.passes);
}

TEST_CASE("error cost: none and no error cost nothing, and a bias by chance below zero is none",
          "[film]")
{
    CHECK(error_cost({}, {}, 0.1, {1, 1}).passes == 0);
    CHECK(error_law({}, kAlpha).by_pass == 0);
    CHECK(passes_for({0, 0}, 0) == kFewestBatches);
    CHECK(std::isinf(passes_for({1, 1}, 0)));
    auto checks = checks_of({0.3, 0.2}, 8);
    checks.back().error.bias2 = -0.1;
    CHECK(error_after(error_law(checks, kAlpha), 8) == Approx(checks.back().error.error));
}
