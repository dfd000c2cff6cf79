#include "render/film/zstd_result.h"

#include <catch2/catch.hpp>

using namespace hipmap;

namespace {

/// What a call returns that fails so.
std::size_t failure(ZSTD_ErrorCode code)
{
    return std::size_t{0} - static_cast<std::size_t>(code);
}

} // namespace

TEST_CASE("zstd_succeeded: lack of memory is no damage", "[film]")
{
    CHECK(zstd_succeeded(0));
    CHECK(zstd_succeeded(1 << 20));
    CHECK_FALSE(zstd_succeeded(failure(ZSTD_error_corruption_detected)));
    CHECK_THROWS_AS(zstd_succeeded(failure(ZSTD_error_memory_allocation)), std::bad_alloc);
}

TEST_CASE("require_made: null is lack of memory", "[film]")
{
    int made = 1;
    CHECK(require_made(&made) == &made);
    CHECK_THROWS_AS(require_made(static_cast<int*>(nullptr)), std::bad_alloc);
}
