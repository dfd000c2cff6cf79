#include "common/command_line/memory_limit.h"

#include <catch2/catch.hpp>
#include <sys/resource.h>

#include <algorithm>

using namespace hipmap;

TEST_CASE("memory_for_a_program: what is available, with swap", "[command_line]")
{
    CHECK(memory_for_a_program("MemTotal:       1000 kB\nMemFree:  1 kB\nMemAvailable:   800 kB\n"
                               "SwapTotal: 50 kB\nSwapFree:   20 kB\n") == 820 * 1024);
    CHECK(memory_for_a_program("MemTotal: 1000 kB\nMemAvailable: 800 kB\n") == 800 * 1024);
}

TEST_CASE("memory_for_a_program: half of the memory where others hold more", "[command_line]")
{
    CHECK(memory_for_a_program("MemTotal: 1000 kB\nMemAvailable: 100 kB\nSwapFree: 0 kB\n") ==
          500 * 1024);
}

TEST_CASE("memory_for_a_program: nothing is known of other systems", "[command_line]")
{
    CHECK(!memory_for_a_program(""));
    CHECK(!memory_for_a_program("MemTotal: 1000 kB\n"));
    CHECK(!memory_for_a_program("MemTotal: many\nMemAvailable: some\n"));
}

TEST_CASE("limit_memory: a lower limit stays", "[command_line]")
{
    rlimit before = {};
    REQUIRE(getrlimit(RLIMIT_DATA, &before) == 0);
    rlimit low = before;
    low.rlim_cur = std::min<rlim_t>(before.rlim_max, 1 << 30);
    // A sanitizer takes more than the limit, so nothing is checked while it holds.
    rlimit after = {};
    const int lowered = setrlimit(RLIMIT_DATA, &low);
    limit_memory();
    const int read = getrlimit(RLIMIT_DATA, &after);
    const int restored = setrlimit(RLIMIT_DATA, &before);
    REQUIRE(lowered == 0);
    REQUIRE(read == 0);
    REQUIRE(restored == 0);
    CHECK(after.rlim_cur == low.rlim_cur);
}
