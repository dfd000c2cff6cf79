#include "render/film/rare_samples.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace hipmap;

namespace {

constexpr std::size_t kWidth = 100;

/// Samples of one pixel each, far from each other.
std::vector<OutstandingPixel> lone_pixels(std::size_t count, double noise, bool again = false)
{
    std::vector<OutstandingPixel> out;
    for (std::size_t i = 0; i < count; ++i)
        out.push_back({5 * kWidth * i, i % 8, noise, again});
    return out;
}

std::vector<OutstandingPixel> below(std::vector<OutstandingPixel> pixels,
                                    const std::vector<OutstandingPixel>& others)
{
    const std::size_t first = pixels.empty() ? 0 : pixels.back().pixel + 5 * kWidth;
    for (OutstandingPixel other : others) {
        other.pixel += first;
        pixels.push_back(other);
    }
    return pixels;
}

long count_removed(const RareSamples& rare)
{
    return std::ranges::count(rare.removed, 1);
}

} // namespace

TEST_CASE("judge_rare_samples: of one sample all noise may be missing", "[film]")
{
    CHECK(judge_rare_samples({}, kWidth) == RareSamples{});
    const RareSamples one = judge_rare_samples(lone_pixels(1, 3), kWidth);
    CHECK(one.removed == std::vector<std::uint8_t>{1});
    CHECK(one.missing == Approx(3));
    CHECK(one.most_missing == Approx(3 * 4.74).epsilon(0.01));
}

TEST_CASE("judge_rare_samples: many that hit no pixel twice are rare", "[film]")
{
    const RareSamples rare = judge_rare_samples(lone_pixels(64, 3), kWidth);
    CHECK(count_removed(rare) == 64);
    CHECK(rare.missing == Approx(64 * 3 * 2 / 17.0));
    CHECK(rare.most_missing < 1.25 * rare.missing);
}

TEST_CASE("judge_rare_samples: what the filter spreads is one sample", "[film]")
{
    std::vector<OutstandingPixel> pixels;
    for (const std::size_t y : {7, 8, 9})
        for (const std::size_t x : {30, 31, 32})
            pixels.push_back({y * kWidth + x, 2, 1.0, false});
    CHECK(judge_rare_samples(pixels, kWidth).missing == Approx(9)); // as of one
    for (std::size_t i = 0; i < pixels.size(); ++i)
        pixels[i].batch = i % 3; // three samples side by side
    CHECK(judge_rare_samples(pixels, kWidth).missing == Approx(9 * 2 * 0.25));
    // The end of a row is not beside the begin of the next one.
    const std::vector<OutstandingPixel> ends{{8 * kWidth - 1, 2, 1.0}, {8 * kWidth, 2, 1.0}};
    CHECK(judge_rare_samples(ends, kWidth).missing == Approx(2 * 2 / 3.0));
}

TEST_CASE("judge_rare_samples: what is often hit twice stays, brighter and rarer light does not",
          "[film]")
{
    const auto often = below(lone_pixels(8, 1), lone_pixels(8, 1, true));
    CHECK(count_removed(judge_rare_samples(often, kWidth)) == 0);
    const RareSamples both = judge_rare_samples(below(lone_pixels(32, 100), often), kWidth);
    CHECK(count_removed(both) > 24);
    for (std::size_t i = 32; i < both.removed.size(); ++i)
        CHECK(both.removed[i] == 0);
}

TEST_CASE("judge_rare_samples: one sample far above those that are hit twice is rare", "[film]")
{
    const auto judged = [](double noise) {
        const auto others = below(lone_pixels(1, 1), lone_pixels(1, 1.2, true));
        return judge_rare_samples(below(lone_pixels(1, noise), others), kWidth);
    };
    // Hit 2 (1 + 1/2)/(1 + 10 + 1) times: the other one is dimmer by 10, and hit so much more
    // often.
    const RareSamples bright = judged(100);
    CHECK(bright.removed == std::vector<std::uint8_t>{1, 0, 0});
    CHECK(bright.missing == Approx(2 * 0.25 * 100));
    CHECK(count_removed(judged(4)) == 0);
}
