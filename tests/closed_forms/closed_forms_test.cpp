#include "tests/closed_forms/find_forms.h"
#include "tests/support/form_factor.h"
#include "tests/support/fresnel.h"

#include <catch2/catch.hpp>

using namespace hipmap;

namespace {

/// Standard errors of so much, relative to what is expected, would hide too much.
constexpr double kMostNoise = 0.03;

void check(const std::vector<FoundForm>& rows)
{
    for (const FoundForm& row : rows) {
        INFO(row.form << ", " << row.method << ": " << row.found.mean() << " +- "
                      << row.found.standard_error() << ", expected " << row.expected);
        CHECK(std::abs(z_score(row)) < kMostZ);
        CHECK(row.found.standard_error() < kMostNoise * row.expected);
    }
}

/// Each form by itself, and that all together are not farther off than probability has it.
void check(const Method& method)
{
    const auto passes = method.traces_paths() ? kPassesOfPaths : kPassesOfForms;
    double squares = 0, forms = 0;
    for (const ClosedForm& form : closed_forms()) {
        const std::vector<FoundForm> rows = find_form(form, method, passes);
        if (!rows[0].why_not.empty())
            continue;
        check(rows);
        squares += z_score(rows[0]) * z_score(rows[0]);
        ++forms;
    }
    CHECK(forms > 10);
    CHECK((squares - forms) / std::sqrt(2 * forms) < kMostZ);
}

} // namespace

TEST_CASE("closed forms: integrator progressive finds them, by all its radii", "[closed_forms]")
{
    check(kMethods[0]);
}

TEST_CASE("closed forms: integrator direct finds them by shadow rays", "[closed_forms]")
{
    check(kMethods[1]);
}

TEST_CASE("closed forms: integrator direct finds them by photons alone", "[closed_forms]")
{
    check(kMethods[2]);
}

TEST_CASE("closed forms: integrator path finds them", "[closed_forms]")
{
    check(kMethods[3]);
}

TEST_CASE("closed forms: integrator progressive finds them with indirect light by paths",
          "[closed_forms]")
{
    check(kMethods[4]);
}

TEST_CASE("closed forms: photons take out of a ball what they bring less what it absorbs",
          "[closed_forms]")
{
    check(find_power_from_glass(kPassesOfForms));
}

TEST_CASE("closed forms: what they are made of agrees where two say the same", "[closed_forms]")
{
    const std::vector<glm::dvec3> square{{0, 2, 0}, {1, 2, 0}, {1, 2, 3}, {0, 2, 3}};
    CHECK(polygon_irradiance({0, 0, 0}, {0, 1, 0}, square) == Approx(corner_rectangle(1, 3, 2)));
    // Mean over a square of what four rectangles above each of its points bring.
    const double side = 0.8;
    const double mean = mean_over_square(side, [&](double x, double y) {
        double sum = 0;
        for (const double a : {side / 2 - x, side / 2 + x})
            for (const double b : {side / 2 - y, side / 2 + y})
                sum += corner_rectangle(a, b, 1);
        return sum / M_PI;
    });
    CHECK(mean == Approx(facing_squares(side)).epsilon(1e-4));
    CHECK(fresnel(1, 1.5) == Approx(0.04));
    CHECK(through_slab(0.04, 1) == Approx(0.96 / 1.04)); // reflections between both sides
    CHECK(out_of_ball(0.3, 1) == Approx(1));             // nothing is lost
}
