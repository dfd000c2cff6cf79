#include "common/math/sort_eight.h"

#include <catch2/catch.hpp>

#include <limits>

using namespace hipmap;

TEST_CASE("sort_eight: all orders of zeros and ones are sorted, so all orders of numbers are")
{
    // Knuth's principle of zeros and ones, for networks.
    for (unsigned bits = 0; bits < 256; ++bits) {
        std::array<float, 8> values{};
        for (std::size_t i = 0; i < values.size(); ++i)
            values[i] = static_cast<float>(bits >> i & 1u);
        std::array<float, 8> wanted = values;
        std::sort(wanted.begin(), wanted.end());
        sort_eight(values);
        CHECK(values == wanted);
    }
}

TEST_CASE("sort_eight: infinite numbers come last")
{
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    std::array<float, 8> values{3, kInfinity, -1, 2, kInfinity, 0, 8, 2};
    sort_eight(values);
    CHECK(values == std::array<float, 8>{-1, 0, 2, 2, 3, 8, kInfinity, kInfinity});
}
