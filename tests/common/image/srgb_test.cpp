#include "common/image/srgb.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

namespace hipmap {

namespace {

/// The decoding half of IEC 61966-2-1, in double.
double linear_from_srgb(double value)
{
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

} // namespace

TEST_CASE("srgb_from_linear: undoes the decoding formula of the standard", "[image]")
{
    CHECK(srgb_from_linear(0.0f) == 0.0f);
    CHECK(srgb_from_linear(1.0f) == Approx(1.0));
    for (int level = 0; level <= 255; ++level) {
        const double value = level / 255.0;
        CHECK(srgb_from_linear(static_cast<float>(linear_from_srgb(value))) ==
              Approx(value).epsilon(1e-5).margin(1e-6));
    }
}

TEST_CASE("level_of: every level comes back from its linear value", "[image]")
{
    for (int level = 0; level <= 255; ++level) {
        const auto linear = static_cast<float>(linear_from_srgb(level / 255.0));
        CHECK(level_of(srgb_from_linear(linear)) == level);
    }
}

TEST_CASE("level_of: what is not in 0 to 1 is clipped", "[image]")
{
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    CHECK(level_of(-1.0f) == 0);
    CHECK(level_of(-kInfinity) == 0);
    CHECK(level_of(std::numeric_limits<float>::quiet_NaN()) == 0);
    CHECK(level_of(1.0f) == 255);
    CHECK(level_of(1e30f) == 255);
    CHECK(level_of(kInfinity) == 255);
    CHECK(level_of(0.49f / 255) == 0);
    CHECK(level_of(0.51f / 255) == 1);
}

} // namespace hipmap
