#include "common/math/random.h"
#include "tests/support/statistics.h"

#include <catch2/catch.hpp>

#include <set>
#include <vector>

using namespace hipmap;

namespace {

RandomSequence sequence(std::uint64_t path, std::uint64_t index)
{
    return {7, RandomStream::eye_paths, 3, path, index};
}

/// z of a chi-square sum: its square and cube root are nearly normal (Wilson and Hilferty 1931).
double z_of_counts(const std::vector<int>& counts)
{
    double total = 0, chi2 = 0;
    for (const int count : counts)
        total += count;
    const double wanted = total / double(counts.size());
    for (const int count : counts)
        chi2 += (count - wanted) * (count - wanted) / wanted;
    const double freedom = double(counts.size()) - 1;
    const double spread = 2 / (9 * freedom);
    return (std::cbrt(chi2 / freedom) - (1 - spread)) / std::sqrt(spread);
}

} // namespace

TEST_CASE("bits are reversed")
{
    CHECK(reverse_bits(1u) == 0x80000000u);
    CHECK(reverse_bits(0x12345678u) == 0x1e6a2c48u);
}

TEST_CASE("aligned samples of a path have one in each box of every shape")
{
    for (const int log2_count : {1, 4, 7})
        for (std::uint64_t path = 0; path < 20; ++path)
            for (int wide = 0; wide <= log2_count; ++wide) {
                const int count = 1 << log2_count, across = 1 << wide, down = count / across;
                std::set<int> boxes;
                for (int i = 0; i < count; ++i) {
                    RandomSequence random = sequence(path, 5 * std::uint64_t(count) + i);
                    random.next();
                    const glm::vec2 p = random.next2();
                    boxes.insert(int(p.x * float(across)) * down + int(p.y * float(down)));
                }
                CHECK(boxes.size() == std::size_t(count));
            }
}

TEST_CASE("each sample of a path is uniform")
{
    for (const std::uint64_t index : {0ull, 1ull, 6ull, 1000003ull, 1ull << 40}) {
        std::vector<int> boxes(256);
        for (std::uint64_t path = 0; path < 65536; ++path) {
            RandomSequence random = sequence(path, index);
            const glm::vec2 p = random.next2();
            ++boxes[std::size_t(p.x * 16) * 16 + std::size_t(p.y * 16)];
        }
        CHECK(std::abs(z_of_counts(boxes)) < kMostZ);
    }
}

TEST_CASE("dimensions, and samples of different paths, are independent")
{
    std::vector<int> dimensions(256), paths(256), neighbours(256);
    for (std::uint64_t path = 0; path < 65536; ++path) {
        RandomSequence random = sequence(path, 9), next = sequence(path + 1, 9),
                       second = sequence(path, 10);
        const glm::vec2 p = random.next2();
        const auto row = std::size_t(p.x * 16) * 16;
        ++dimensions[row + std::size_t(random.next() * 16)];
        ++paths[row + std::size_t(next.next2().x * 16)];
        second.next2();
        ++neighbours[row + std::size_t(second.next2().y * 16)];
    }
    CHECK(std::abs(z_of_counts(dimensions)) < kMostZ);
    CHECK(std::abs(z_of_counts(paths)) < kMostZ);
    CHECK(std::abs(z_of_counts(neighbours)) < kMostZ);
}
