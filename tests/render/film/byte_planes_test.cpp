#include "render/film/byte_planes.h"

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include <limits>

using namespace hipmap;

namespace {

std::vector<std::int64_t> there_and_back(const std::vector<std::int64_t>& sums)
{
    std::vector<std::int64_t> out(sums.size());
    join_planes(split_into_planes(sums), out);
    return out;
}

} // namespace

TEST_CASE("byte planes: joining restores any sums", "[film]")
{
    CHECK(rc::check(
        [](const std::vector<std::int64_t>& sums) { RC_ASSERT(there_and_back(sums) == sums); }));
    constexpr std::int64_t kLeast = std::numeric_limits<std::int64_t>::min();
    constexpr std::int64_t kMost = std::numeric_limits<std::int64_t>::max();
    const std::vector<std::int64_t> far = {kLeast, kMost, 0, kMost, kLeast, -1, 0, kMost, kLeast};
    CHECK(there_and_back(far) == far);
}

TEST_CASE("byte planes: neighbours that differ little leave high bytes of zero", "[film]")
{
    const std::vector<std::byte> planes =
        split_into_planes(std::vector<std::int64_t>{5, -5, 0, 1005, 995, -1000, 1004, 996, -1001});
    CHECK(std::vector<std::byte>(planes.begin() + 18, planes.end()) ==
          std::vector<std::byte>(planes.size() - 18));
    CHECK(planes[1] == std::byte{9});              // -5
    CHECK(planes[6] == std::byte{1});              // 1004 - 1005
    CHECK(planes[9 + 3] == std::byte{2000 / 256}); // 1005 - 5
}
