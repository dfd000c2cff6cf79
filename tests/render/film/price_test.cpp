#include "render/film/price.h"

#include <catch2/catch.hpp>

using namespace hipmap;

namespace {

constexpr double kAlpha = 2.0 / 3;

/// Checks of a film whose error follows a law exactly, at 0.5 s a pass.
std::vector<ErrorCheck> checks_of(const ErrorLaw& law, BiasKnowledge bias, std::uint64_t last)
{
    std::vector<ErrorCheck> checks;
    for (std::uint64_t passes = next_check(0); passes <= last; passes = next_check(passes)) {
        ImageError error;
        error.bias = bias;
        error.error = error_after(law, static_cast<double>(passes));
        checks.push_back({passes, 0.5 * static_cast<double>(passes), error});
    }
    return checks;
}

} // namespace

TEST_CASE("price: checks are spaced geometrically and never repeat", "[film]")
{
    std::vector<std::uint64_t> found;
    for (std::uint64_t passes = 0; passes < 200; passes = next_check(passes))
        found.push_back(passes);
    CHECK(found == std::vector<std::uint64_t>{0, 8, 11, 16, 23, 32, 45, 64, 91, 128, 181});
    CHECK(next_check(12) == 16);
    std::vector<std::uint64_t> looks;
    for (std::uint64_t passes = 0; passes < 23; passes = next_look(passes))
        looks.push_back(passes);
    CHECK(looks == std::vector<std::uint64_t>{0, 2, 3, 4, 6, 8, 11, 16});
    CHECK(next_check(16) == 23);
}

TEST_CASE("price: a law of both parts is found again, and halving costs what it says", "[film]")
{
    for (const ErrorLaw& law : {ErrorLaw{0.3, 0.2}, ErrorLaw{0, 0.1}, ErrorLaw{0.5, 0}}) {
        const auto checks = checks_of(law, BiasKnowledge::from_radii, 128);
        const ErrorLaw found = fit_law(checks, kAlpha);
        CHECK(found.by_pass == Approx(law.by_pass).margin(1e-6));
        CHECK(found.by_photon == Approx(law.by_photon).margin(1e-6));
        const double half = checks.back().error.error / 2;
        const Price price = price_of(checks, found, half, 1000);
        CHECK(error_after(law, price.passes) <= half * (1 + 1e-9));
        CHECK(error_after(law, price.passes - 1) > half * (1 - 1e-9));
        CHECK(price.seconds == Approx(0.5 * price.passes));
        CHECK(price.photons == 1000 * price.passes);
    }
}

TEST_CASE("price: looks before every batch holds a pass do not bend the law", "[film]")
{
    auto checks = checks_of({0.3, 0.2}, BiasKnowledge::from_radii, 128);
    const ErrorLaw law = fit_law(checks, kAlpha);
    ImageError early;
    early.bias = BiasKnowledge::from_radii;
    early.error = 50;
    checks.insert(checks.begin(), {{2, 1.0, early}, {6, 3.0, early}});
    CHECK(fit_law(checks, kAlpha).by_pass == law.by_pass);
    CHECK(fit_law(checks, kAlpha).by_photon == law.by_photon);
}

TEST_CASE("price: to halve noise costs four times the passes, noise and bias of photons eight",
          "[film]")
{
    const auto factor = [](const ErrorLaw& law, BiasKnowledge bias) {
        const auto checks = checks_of(law, bias, 128);
        return price_of(checks, fit_law(checks, kAlpha), checks.back().error.error / 2, 1).passes /
               128;
    };
    CHECK(factor({0.3, 0}, BiasKnowledge::unbiased) == Approx(4).epsilon(0.01));
    CHECK(factor({0.3, 0}, BiasKnowledge::unknown) == Approx(4).epsilon(0.01));
    CHECK(factor({0, 0.3}, BiasKnowledge::from_radii) == Approx(8).epsilon(0.01));
}

TEST_CASE("price: one check takes the dearer law, none and no error cost nothing", "[film]")
{
    const auto checks = checks_of({0.1, 0.1}, BiasKnowledge::from_radii, 8);
    REQUIRE(checks.size() == 1);
    const ErrorLaw law = fit_law(checks, kAlpha);
    CHECK(law.by_pass == 0);
    CHECK(error_after(law, 8) == Approx(checks[0].error.error));
    CHECK(price_of({}, {}, 0.1, 1).passes == 0);
    CHECK(fit_law({}, kAlpha).by_pass == 0);
    CHECK(passes_for({0, 0}, 0) == 1);
    CHECK(std::isinf(passes_for({1, 1}, 0)));
}

TEST_CASE("price: photons' part falls by alpha or by the bias, whichever is slower", "[film]")
{
    const auto [alpha, power] =
        GENERATE(std::pair{0.5, 0.5}, std::pair{0.75, 0.5}, std::pair{2.0 / 3, 2.0 / 3});
    const auto checks = checks_of({0.3, 0.2, power}, BiasKnowledge::from_radii, 128);
    const ErrorLaw found = fit_law(checks, alpha);
    CHECK(found.photon_power == Approx(power));
    CHECK(found.by_pass == Approx(0.3).margin(1e-6));
    CHECK(found.by_photon == Approx(0.2).margin(1e-6));
}
