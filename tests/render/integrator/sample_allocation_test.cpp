#include "common/math/random.h"
#include "render/integrator/sample_allocation.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

using namespace hipmap;

namespace {

/// Of mean one; the right half deviates three times as much as the left.
Image noisy_image(std::uint64_t sample, int size = 64)
{
    Image image(size, size);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            RandomSequence random(1, RandomStream::pictures, sample,
                                  static_cast<std::uint64_t>(y * size + x));
            const float deviation = x < size / 2 ? 0.1f : 0.3f;
            image.at(x, y) = Rgb(1 + deviation * (2 * random.next() - 1));
        }
    return image;
}

double mean_samples(const SampleAllocation& allocation, int width, int from_x, int to_x)
{
    double sum = 0;
    const int height = static_cast<int>(allocation.samples.size()) / width;
    for (int y = 0; y < height; ++y)
        for (int x = from_x; x < to_x; ++x)
            sum += allocation.samples[static_cast<std::size_t>(y * width + x)];
    return sum / (height * (to_x - from_x));
}

} // namespace

TEST_CASE("sample allocation: in proportion to the deviation, the mean kept", "[integrator]")
{
    const SampleAllocation allocation =
        allocate_samples({noisy_image(0), noisy_image(1), {}}, 128, 128, 16);
    const double calm = mean_samples(allocation, 128, 0, 36);
    const double noisy = mean_samples(allocation, 128, 92, 128);
    CHECK(noisy / calm == Approx(3).epsilon(0.1));
    CHECK(mean_samples(allocation, 128, 0, 128) == Approx(16).epsilon(0.01));
}

TEST_CASE("sample allocation: what is rare around a pixel counts, though its own samples missed it",
          "[integrator]")
{
    Image first(96, 96);
    for (std::size_t i = 0; i < first.pixels.size(); ++i)
        first.pixels[i] = Rgb(1);
    Image second = first;
    RandomSequence random(1, RandomStream::pictures, 0, 0);
    for (Rgb& pixel : second.pixels)
        if (random.next() < 0.01f) // 25 pixels without one are common, 625 are not
            pixel = Rgb(2);
    const auto samples = allocate_samples({first, second, {}}, 96, 96, 100).samples;
    // A quarter is the least that there can be.  Corners see fewer pixels around them.
    const auto few = std::ranges::count_if(samples, [](std::uint16_t n) { return n < 27; });
    CHECK(static_cast<double>(few) < 0.03 * static_cast<double>(samples.size()));
    CHECK(*std::ranges::max_element(samples) > 150);
}

TEST_CASE("sample allocation: every pixel has a sample, none very many", "[integrator]")
{
    Image first = noisy_image(0), second = first;
    second.at(10, 10) = Rgb(1e6f);
    second.at(20, 20) = Rgb(std::numeric_limits<float>::quiet_NaN());
    second.at(30, 30) = Rgb(std::numeric_limits<float>::infinity());
    for (const std::uint32_t mean : {1u, 2u, 60'000u}) {
        const SampleAllocation allocation = allocate_samples({first, second, {}}, 32, 64, mean);
        REQUIRE(allocation.samples.size() == 32 * 64);
        for (const std::uint16_t samples : allocation.samples) {
            CHECK(samples >= 1);
            CHECK(samples <= 8 * mean + 1);
        }
    }
    const Image black(8, 8);
    for (const std::uint16_t samples : allocate_samples({black, black, {}}, 8, 8, 4).samples)
        CHECK(samples == 4); // no pixel has differed from another
}

TEST_CASE("sample allocation: noisy lights have samples of their own, out of the same work",
          "[integrator]")
{
    constexpr std::size_t kCount = 64 * 64, kNoisy = 20 * 64 + 20;
    LightNoise lights{std::vector<float>(kCount, 0.1f), std::vector<float>(kCount, 1e-4f), {}};
    lights.variance[kNoisy] = 100;
    const SampleAllocation with =
        allocate_samples({noisy_image(0), noisy_image(1), lights}, 64, 64, 16);
    REQUIRE(with.lights.size() == kCount);
    for (std::size_t i = 0; i < kCount; ++i)
        CHECK((with.lights[i] > 16) == (i == kNoisy));
    CHECK(mean_samples(with, 64, 0, 64) < 16);
    CHECK(mean_samples(with, 64, 0, 64) > 14);
}

TEST_CASE("sample allocation: long paths count unless hardly any image would find their light",
          "[integrator]")
{
    constexpr std::size_t kCount = 64 * 64, kSeen = 20 * 64 + 20;
    LightNoise lights{std::vector<float>(kCount, 0), std::vector<float>(kCount, 0),
                      std::vector<LongPaths>(kCount)};
    const auto allocated = [&](float chance) {
        lights.long_paths[kSeen] = {.mean = 1, .variance = 1 / chance};
        return allocate_samples({noisy_image(0), noisy_image(1), lights}, 64, 64, 16);
    };
    const SampleAllocation common = allocated(1e-4f);
    REQUIRE(common.lights.size() == kCount);
    CHECK(common.lights[kSeen] == 64 * 16);
    // What it cannot take goes to the others.
    CHECK(mean_samples(common, 64, 0, 64) > 14);
    CHECK(allocated(3e-6f) == allocate_samples({noisy_image(0), noisy_image(1), {}}, 64, 64, 16));
}

TEST_CASE("sample allocation: as many points on emissive faces as their part of the noise pays for",
          "[integrator]")
{
    const Image first = noisy_image(0), second = noisy_image(1);
    const auto points_for = [&](float part) {
        Image emissive(64, 64);
        for (std::size_t i = 0; i < emissive.pixels.size(); ++i)
            emissive.pixels[i] = part * (first.pixels[i] - second.pixels[i]);
        return allocate_samples({first, second, {}, &emissive}, 64, 64, 16);
    };
    const SampleAllocation unknown = allocate_samples({first, second, {}}, 64, 64, 16);
    CHECK(unknown.emissive_points == 1);
    CHECK(points_for(0) == unknown);
    CHECK(points_for(0.3f).emissive_points == 1);
    // All of the variance is that of the points: sqrt(0.95 / 0.05).
    const SampleAllocation all = points_for(1);
    CHECK(all.emissive_points == 4);
    CHECK(all.samples == unknown.samples);
    CHECK(checksum(all) != checksum(unknown));
    const Image black(8, 8);
    CHECK(allocate_samples({black, black, {}, &black}, 8, 8, 4).emissive_points == 1);
}

TEST_CASE("sample allocation: its checksum tells allocations apart", "[integrator]")
{
    SampleAllocation allocation = allocate_samples({noisy_image(0), noisy_image(1), {}}, 64, 64, 4);
    const std::uint64_t sum = checksum(allocation);
    CHECK(sum == checksum(allocation));
    ++allocation.samples[100];
    CHECK(sum != checksum(allocation));
    CHECK(checksum(SampleAllocation{}) == 0);
}

TEST_CASE("relative variance: of a sample, over the square of the brightness around",
          "[integrator]")
{
    const Image first = noisy_image(0), second = noisy_image(1), third = noisy_image(2);
    Image differences = first;
    for (std::size_t i = 0; i < first.pixels.size(); ++i)
        differences.pixels[i] = first.pixels[i] - third.pixels[i];
    const double expected = (0.01 + 0.09) / 3 / 2 / 1.01; // of uniform numbers
    CHECK(relative_variance(first, second, differences) == Approx(expected).epsilon(0.05));
    // Pixels that both images miss have a difference all the same.
    Image holes = first;
    for (std::size_t i = 0; i < holes.pixels.size(); i += 7)
        holes.pixels[i] = Rgb(0);
    CHECK(relative_variance(holes, holes, differences) < 2 * expected);
    CHECK(relative_variance({}, {}, {}) == 0);
}
