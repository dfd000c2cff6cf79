#include "render/integrator/time_left.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <functional>

using namespace hipmap;

namespace {

/// Seconds of a pass, by its number.
using Cost = std::function<double(int)>;
/// What a pass tells of itself when `share` of its time is over.
using Part = std::function<double(double)>;

/// Returns the largest factor between predicted and true time left, either way, from the second
/// update on.
/// Updates come every `interval` s, while more than an interval is left.
double worst_factor(int passes, const Cost& cost, const Part& part, double interval)
{
    double end = 0;
    for (int pass = 0; pass < passes; ++pass)
        end += cost(pass);
    PassTimes times;
    double worst = 1, next = 2 * interval;
    for (int pass = 0; pass < passes; ++pass) {
        for (; next < times.begun + cost(pass); next += interval) {
            const double share = (next - times.begun) / cost(pass);
            const double told = seconds_left(times, next, part(share), passes - pass).value_or(-1);
            REQUIRE(told >= 0);
            if (const double left = end - next; left > interval)
                worst = std::max({worst, told / left, left / told});
        }
        times.whole.push_back(cost(pass));
        times.begun += cost(pass);
    }
    return worst;
}

} // namespace

TEST_CASE("time left: within 1.5x from the second update on", "[time-left]")
{
    const Part even = [](double share) { return share; };
    const Part late = [](double share) { return share * share; };
    const Part early = [](double share) { return std::sqrt(share); };
    const Cost same = [](int) { return 3.1; };
    const Cost falling = [](int pass) { return 2 + 1.5 / (1 + pass); };
    const Cost rough = [](int pass) { return pass % 2 == 0 ? 2.5 : 3.5; };
    const Cost warm = [](int pass) { return pass == 0 ? 4.0 : 3.0; };
    for (const Cost& cost : {same, falling, rough, warm})
        for (const Part& part : {even, late, early})
            for (const int passes : {4, 16, 100})
                CHECK(worst_factor(passes, cost, part, 5) < 1.5);
}

TEST_CASE("time left: by the part of the first pass; without one, unknown", "[time-left]")
{
    CHECK(!seconds_left({}, 1, 0, 16));
    CHECK(seconds_left({}, 1, 0.5, 16).value() == Approx(31));
    CHECK(seconds_left({}, 1, 1, 1).value() == Approx(0));
    const PassTimes slow = {{2}, 2};
    CHECK(seconds_left(slow, 9, 0.5, 1).value() > 0);
    CHECK(seconds_left(slow, 9, 0.5, 1).value() < 0.2);
}

TEST_CASE("time left: no pass is counted that would not be over in time", "[time-left]")
{
    CHECK(seconds_to_limit({}, 1, 10) == 9);
    // Passes of 3 s end at 3, 6 and 9; a fourth would end at 12.
    const PassTimes times = {{3}, 3};
    CHECK(seconds_to_limit(times, 4, 10) == Approx(5));
    CHECK(seconds_to_limit(times, 4, 12.5) == Approx(8));
    CHECK(seconds_to_limit(times, 4, 5) == Approx(2)); // the one under way is done anyhow
}
