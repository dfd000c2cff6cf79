#include "common/setting.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace hipmap;

TEST_CASE("setting: its text names the value and no other", "[setting]")
{
    CHECK(text_of(Setting{"photons", std::uint64_t{200000}}) == "photons=200000");
    CHECK(text_of(Setting{"caustics", true}) == "caustics=on");
    CHECK(text_of(Setting{"caustics", false}) == "caustics=off");
    CHECK(text_of(Setting{"maps", "shared"}) == "maps=shared");
    CHECK(text_of(Setting{"time", {}}) == "time=none");
    CHECK(text_of(Setting{"alpha", 0.5}) == "alpha=0.5");
    CHECK(text_of(SettingValue(0.1)) != text_of(SettingValue(std::nextafter(0.1, 1))));
}
